#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// VolumeSide: one of the six sides of a volume; "low" is where the voxel index is 0.
enum class VolumeSide { iLow, iHigh, jLow, jHigh, kLow, kHigh };
constexpr std::array<const char*, 6> enumNames(VolumeSide) {
  return {"i-low", "i-high", "j-low", "j-high", "k-low", "k-high"};
}

// ScanOptions: what the file does not tell about the recording.
struct ScanOptions {
  VolumeSide probeSide = VolumeSide::jLow;
  VolumeSide topSide = VolumeSide::iHigh;
};

template <class F, class O>
requires OptionsOf<O, ScanOptions>
void fields(F&& f, O& o) {
  f(Field{"probeSide", "side of the volume where the probe was, if the file does not say"}, o.probeSide);
  f(Field{"topSide", "side of the volume that pictures show at the top, if the file does not say"},
    o.topSide);
}

}  // namespace sonoskin
