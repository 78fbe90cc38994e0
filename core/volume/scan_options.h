#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// VolumeSide: one of the six sides of a volume; "low" is where the voxel index is 0.
enum class VolumeSide { iLow, iHigh, jLow, jHigh, kLow, kHigh };
constexpr std::array<const char*, 6> enumNames(VolumeSide) {
  return {"i-low", "i-high", "j-low", "j-high", "k-low", "k-high"};
}

// BeamOrigin: where the beams start.
enum class BeamOrigin { automatic, given, parallel };
constexpr std::array<const char*, 3> enumNames(BeamOrigin) { return {"automatic", "given", "parallel"}; }

// MirroredAxis: an axis of the voxels that is turned over in the world.
enum class MirroredAxis { none, i, j, k };
constexpr std::array<const char*, 4> enumNames(MirroredAxis) { return {"none", "i", "j", "k"}; }

// ScanOptions: what the file does not tell about the recording.
struct ScanOptions {
  VolumeSide probeSide = VolumeSide::jLow;
  VolumeSide topSide = VolumeSide::iHigh;
  BeamOrigin beamOrigin = BeamOrigin::automatic;
  std::array<double, 3> apex{0, 0, 0};
  std::array<double, 3> spacing{0, 0, 0};
  int volume = 0, time = 1;
  double voxel = 0;
  MirroredAxis mirror = MirroredAxis::none;
  bool regionOnly = false;
  bool half = false;
  std::array<double, 3> cutLow{0, 0, 0}, cutHigh{0, 0, 0};
};

template <class F, class O>
requires OptionsOf<O, ScanOptions>
void fields(F&& f, O& o) {
  f(Field{"probeSide", "side of the volume where the probe was, if the file does not say"}, o.probeSide);
  f(Field{"topSide", "side of the volume that pictures show at the top, if the file does not say"},
    o.topSide);
  f(Field{"beamOrigin",
          "where the beams start: automatic: what the file says, else where the sides of the scanned sector "
          "meet; "
          "given: in scan.apex; parallel: nowhere"},
    o.beamOrigin);
  f(Field{"apex", "where the beams start if scan.beamOrigin is given; in the world of the volume", "mm"},
    o.apex, Range{-10000.0, 10000.0});
  f(Field{"spacing", "from voxel to voxel, for files that give no spacing; 0: unknown", "mm"}, o.spacing,
    Range{0.0, 100.0});
  f(Field{"volume",
          "which of several volumes in a file or folder, as info counts them; 0: it holds one alone; when it "
          "is opened next"},
    o.volume, Range{0, 10000});
  f(Field{"time", "which time step of a recording in time, counted from 1"}, o.time, Range{1, 100000});
  f(Field{"voxel",
          "edge of the voxels that samples of a probe's beams are converted to, for files that hold those; "
          "0: "
          "as fine as they were sampled; when it is opened next",
          "mm"},
    o.voxel, Range{0.0, 10.0});
  f(Field{"mirror",
          "axis of a volume that is turned over in the world, for files whose left and right come out "
          "swapped"},
    o.mirror);
  f(Field{"regionOnly",
          "blanks what lies outside of the picture in ultrasound of DICOM, such as names that are burnt in, "
          "where the file says where the picture lies; when it is opened next"},
    o.regionOnly);
  f(Field{"half",
          "reads a volume at half its resolution, in an eighth of the memory; when it is opened next"},
    o.half);
  f(Field{"cutLow", "left out at the sides i-low, j-low, k-low of a volume when it is opened next", "mm"},
    o.cutLow, Range{0.0, 1000.0});
  f(Field{"cutHigh", "left out at the sides i-high, j-high, k-high of a volume when it is opened next", "mm"},
    o.cutHigh, Range{0.0, 1000.0});
}

}  // namespace sonoskin
