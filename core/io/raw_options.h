#pragma once

#include <array>

#include "core/base/fields.h"
#include "core/io/number_type.h"

namespace sonoskin {

// ByteOrder: which byte of a number comes first.
enum class ByteOrder { little, big };
constexpr std::array<const char*, 2> enumNames(ByteOrder) { return {"little", "big"}; }

// RawGrid: where the numbers of a file without a header were sampled.
enum class RawGrid { cartesian, sector, pyramid };
constexpr std::array<const char*, 3> enumNames(RawGrid) { return {"cartesian", "sector", "pyramid"}; }

// RawOptions: what a file without a header (.raw, .bin, .img) does not tell. Its grids are those of
// core/volume/sample_grid.h, with beams and pictures at even angles.
struct RawOptions {
  std::array<int, 3> dims{0, 0, 0};
  NumberType type = NumberType::uint8;
  ByteOrder byteOrder = ByteOrder::little;
  int header = 0;
  int timeSteps = 1;
  std::array<double, 3> spacing{0, 0, 0};
  RawGrid grid = RawGrid::cartesian;
  double firstRadius = 0, axisDepth = 0, fanAngle = 0, sweepAngle = 0, aperture = 0;
};

template <class F, class O>
requires OptionsOf<O, RawOptions>
void fields(F&& f, O& o) {
  f(Field{"dims",
          "numbers along the three axes of a file without a header, the fastest first; 0: not told; when it "
          "is opened next"},
    o.dims, Range{0, 65535});
  f(Field{"type", "how one number is stored"}, o.type);
  f(Field{"byteOrder", "which byte of a number comes first"}, o.byteOrder);
  f(Field{"header", "before the first number; -1: all that is more than the numbers", "bytes"}, o.header,
    Range{-1, 1'000'000'000});
  f(Field{"timeSteps", "volumes one after another in the file"}, o.timeSteps, Range{1, 65535});
  f(Field{"spacing",
          "from number to number along the three axes; a sector needs the first, along its beams, a pyramid "
          "the first two, within its pictures; 0: unknown",
          "mm"},
    o.spacing, Range{0.0, 100.0});
  f(Field{"grid",
          "where the numbers were sampled: cartesian: on voxels; sector: along the beams of a fan that was "
          "swept (axes: along the beam, fan, sweep); pyramid: on straight pictures that draw apart with "
          "the depth (axes: across, depth, pictures)"},
    o.grid);
  f(Field{"firstRadius", "of a sector, from the apex of its fan to the first number", "mm"}, o.firstRadius,
    Range{0.0, 1000.0});
  f(Field{"axisDepth", "of a sector, from the apex of its fan to the axis that it was swept about", "mm"},
    o.axisDepth, Range{-1000.0, 1000.0});
  f(Field{"fanAngle", "of a sector, between the outermost beams of its fan", "degrees"}, o.fanAngle,
    Range{0.0, 170.0});
  f(Field{"sweepAngle",
          "of a sector, between the outermost pictures of its sweep; of a pyramid, between the sides of its "
          "stack of pictures",
          "degrees"},
    o.sweepAngle, Range{0.0, 170.0});
  f(Field{"aperture", "of a pyramid, how wide the stack of pictures is at their near edge", "mm"}, o.aperture,
    Range{0.0, 1000.0});
}

// isTold: whether the numbers of a file without a header were told at all.
inline bool isTold(const RawOptions& options) {
  return options.dims[0] > 0 || options.dims[1] > 0 || options.dims[2] > 0;
}

}  // namespace sonoskin
