#include "core/volume/scan_size.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/volume/resample.h"

namespace sonoskin {
namespace {

// VoxelBox: voxels from `first` on.
struct VoxelBox {
  glm::ivec3 first, dims;
};

// The voxels of a volume but for what lies within some mm of its sides.
VoxelBox boxLeft(const Geometry& g, const ScanOptions& options) {
  glm::ivec3 first, last;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = std::size_t(axis);
    const double low = std::ceil(options.cutLow[a] / g.spacing[axis] - 1e-6);
    const double high = std::floor(g.dims[axis] - 1 - options.cutHigh[a] / g.spacing[axis] + 1e-6);
    require(high - low >= 2,
            "nothing is left of axis {}: scan.cutLow and scan.cutHigh take {:.1f} and {:.1f} mm off its "
            "{:.1f} mm",
            "ijk"[axis], options.cutLow[a], options.cutHigh[a], (g.dims[axis] - 1) * g.spacing[axis]);
    first[axis] = int(low);
    last[axis] = int(high);
  }
  return {first, last - first + 1};
}

template <class T>
std::shared_ptr<const Volume<T>> cut(const Volume<T>& volume, const VoxelBox& box) {
  return std::make_shared<const Volume<T>>(cropVolume(volume, box.first, box.dims));
}

}  // namespace

void reduceScan(Scan& scan, const ScanOptions& options, const Progress& progress) {
  const std::array<double, 3> nothing{};
  const bool cuts = options.cutLow != nothing || options.cutHigh != nothing;
  if (!cuts && !options.half) return;
  if (cuts) {
    const VoxelBox box = boxLeft(scan.volume->geometry, options);
    scan.volume = cut(*scan.volume, box);
    if (scan.mask) scan.mask = cut(*scan.mask, box);
  }
  if (options.half) {
    if (scan.mask) scan.mask = std::make_shared<const Volume<std::uint8_t>>(halveMask(*scan.mask, progress));
    scan.volume = std::make_shared<const Volume<float>>(halveResolution(*scan.volume, progress));
  }
  scan.key = scanKey(*scan.volume, scan.beam);
  if (scan.mask) scan.key = maskedKey(scan.key, *scan.mask);
}

void requireMemory(const Geometry& geometry, double bytesPerVoxel, std::size_t available) {
  constexpr double kGigabyte = 1e9;
  const double needed = bytesPerVoxel * double(geometry.voxels());
  if (needed <= double(available)) return;
  const glm::ivec3& d = geometry.dims;
  throw Error(
      fmt::format(
          "The volume has {} x {} x {} voxels and takes {:.1f} GB of memory, but {:.1f} GB are free; read "
          "it at half the resolution (scan.half on), or a part of it (scan.cutLow, scan.cutHigh), or close "
          "other programs.",
          d.x, d.y, d.z, needed / kGigabyte, double(available) / kGigabyte),
      Error::Kind::system);
}

}  // namespace sonoskin
