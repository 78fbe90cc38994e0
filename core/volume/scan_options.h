#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// ProbeSide: the side of the volume at which the probe was held, where the file does not tell.
enum class ProbeSide { iLow, iHigh, jLow, jHigh, kLow, kHigh };
constexpr std::array<const char*, 6> enumNames(ProbeSide) {
  return {"i-low", "i-high", "j-low", "j-high", "k-low", "k-high"};
}

// ScanOptions: what the file does not tell about the recording.
struct ScanOptions {
  ProbeSide probeSide = ProbeSide::jLow;
};

template <class F, class O>
  requires OptionsOf<O, ScanOptions>
void fields(F&& f, O& o) {
  f(Field{"probeSide", "side of the volume where the probe was, if the file does not say"}, o.probeSide);
}

}  // namespace sonoskin
