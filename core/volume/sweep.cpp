#include "core/volume/sweep.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/volume/fill_gaps.h"

namespace sonoskin {
namespace {

constexpr double kMostVoxels = double(1 << 27), kManyVoxels = double(1 << 25);
constexpr double kCoarsest = 3;      // pixels per voxel, where pictures lie far apart
constexpr int kFill = 3;             // voxels from pictures to which gaps between them are filled
constexpr std::ptrdiff_t kSlab = 4;  // planes of one task

glm::dvec3 at(const glm::dmat4& pose, double i, double j) {
  return glm::dvec3(pose * glm::dvec4(i, j, 0, 1));
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void checkPoses(const std::vector<glm::dmat4>& poses) {
  require(poses.size() >= 2, "The sweep has {} pictures with a place; two are needed at least.",
          poses.size());
  for (const glm::dmat4& pose : poses) {
    const glm::dvec3 x(pose[0]), y(pose[1]), o(pose[3]);
    const double lengths = glm::length(x) * glm::length(y);
    const bool sound = std::isfinite(lengths) && lengths > 0 && std::abs(glm::dot(x, y)) < 0.1 * lengths &&
                       std::isfinite(glm::length(o));
    require(sound, "The sweep has a picture whose place is none; calibrate the probe again.");
  }
}

// The middle picture's axes: rows, columns made perpendicular, and what is across both.
glm::dmat3 axesOf(const glm::dmat4& pose) {
  const glm::dvec3 x = glm::normalize(glm::dvec3(pose[0]));
  const glm::dvec3 y = glm::normalize(glm::dvec3(pose[1]) - glm::dot(glm::dvec3(pose[1]), x) * x);
  return {x, y, glm::cross(x, y)};
}

template <class T>
double spacingOf(const SweepFrames<T>& frames, const glm::dmat3& axes) {
  const glm::dmat4& pose = frames.poses[frames.poses.size() / 2];
  const double pixel = std::sqrt(glm::length(glm::dvec3(pose[0])) * glm::length(glm::dvec3(pose[1])));
  std::vector<double> apart;
  for (std::size_t f = 1; f < frames.poses.size(); ++f) {
    const auto centre = [&](std::size_t n) {
      return at(frames.poses[n], frames.width / 2.0, frames.height / 2.0);
    };
    apart.push_back(std::abs(glm::dot(centre(f) - centre(f - 1), axes[2])));
  }
  return std::clamp(medianOf(std::move(apart)), pixel, kCoarsest * pixel);
}

// The box of all pictures' corners.
template <class T>
Geometry boxOf(const SweepFrames<T>& frames) {
  Geometry g;
  g.direction = axesOf(frames.poses[frames.poses.size() / 2]);
  glm::dvec3 least(1e300), most(-1e300);
  for (const glm::dmat4& pose : frames.poses)
    for (int corner = 0; corner < 4; ++corner) {
      const glm::dvec3 world =
          at(pose, corner & 1 ? frames.width - 1 : 0, corner & 2 ? frames.height - 1 : 0);
      const glm::dvec3 along = glm::transpose(g.direction) * world;
      least = glm::min(least, along), most = glm::max(most, along);
    }
  double spacing = spacingOf(frames, g.direction);
  const auto voxelsAt = [&](double s) {
    const glm::dvec3 counts = glm::ceil((most - least) / s) + 1.0;
    return counts.x * counts.y * counts.z;
  };
  spacing *= std::cbrt(std::max(1.0, voxelsAt(spacing) / kManyVoxels));
  const glm::dvec3 counts = glm::ceil((most - least) / spacing) + 1.0;
  require(voxelsAt(spacing) <= kMostVoxels,
          "The pictures of the sweep fill a box of {:.0f} x {:.0f} x {:.0f} voxels, more than fit into "
          "memory; choose a part.",
          counts.x, counts.y, counts.z);
  g.dims = glm::max(glm::ivec3(counts), glm::ivec3(2));
  g.spacing = glm::dvec3(spacing);
  g.origin = g.direction * least;
  return g;
}

// Sums: of weighted pixels, and of their weights.
struct Sums {
  Volume<float> values, weights;
};

// Slab: planes [first, last) of the sums; only these are written, so that slabs do not know each other.
struct Slab {
  int first = 0, last = 0;
};

void add(Sums& sums, const glm::ivec3& voxel, float value, float weight) {
  const std::size_t n = sums.values.geometry.index(voxel.x, voxel.y, voxel.z);
  sums.values.data[n] += weight * value;
  sums.weights.data[n] += weight;
}

void addPixel(Sums& sums, const Slab& slab, const glm::dvec3& index, float value) {
  const glm::dvec3 base = glm::floor(index);
  const glm::dvec3 part = index - base;
  const glm::ivec3& d = sums.values.geometry.dims;
  for (int c = 0; c < 8; ++c) {
    const glm::ivec3 step(c & 1, (c >> 1) & 1, c >> 2), voxel = glm::ivec3(base) + step;
    if (voxel.z < slab.first || voxel.z >= slab.last) continue;
    if (voxel.x < 0 || voxel.y < 0 || voxel.x >= d.x || voxel.y >= d.y) continue;
    const glm::dvec3 near = glm::mix(1.0 - part, part, glm::dvec3(step));
    const double weight = near.x * near.y * near.z;
    if (weight > 1e-6) add(sums, voxel, value, float(weight));
  }
}

// Which pixels of a row lie within the planes that reach into the slab.
std::pair<int, int> pixelsIn(const Slab& slab, double first, double step, int count) {
  double from = 0, to = double(count - 1);
  const double least = double(slab.first) - 1, most = double(slab.last);
  if (std::abs(step) > 1e-12) {
    const double a = (least - first) / step, b = (most - first) / step;
    from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
  } else if (first < least || first > most) {
    return {0, 0};
  }
  return to < from ? std::pair(0, 0) : std::pair(int(std::ceil(from)), int(std::floor(to)) + 1);
}

template <class T>
void addFrame(const SweepFrames<T>& frames, std::size_t f, const Slab& slab, Sums& sums) {
  const Geometry& g = sums.values.geometry;
  const glm::dmat4& pose = frames.poses[f];
  const glm::dvec3 origin = g.toIndex(at(pose, 0, 0));
  const glm::dvec3 alongRow = g.toIndex(at(pose, 1, 0)) - origin,
                   alongColumn = g.toIndex(at(pose, 0, 1)) - origin;
  const T* pixels = frames.pixels.data() + f * std::size_t(frames.width) * std::size_t(frames.height);
  for (int j = 0; j < frames.height; ++j) {
    const glm::dvec3 row = origin + double(j) * alongColumn;
    const auto [from, to] = pixelsIn(slab, row.z, alongRow.z, frames.width);
    const T* values = pixels + std::size_t(j) * std::size_t(frames.width);
    for (int i = from; i < to; ++i) {
      const glm::dvec3 index = row + double(i) * alongRow;
      addPixel(sums, slab, index, float(values[i]));
    }
  }
}

SweptVolume meanOf(Sums sums) {
  SweptVolume swept;
  swept.mask = Volume<std::uint8_t>(sums.values.geometry);
  swept.volume = std::move(sums.values);
  for (std::size_t v = 0; v < swept.mask.data.size(); ++v) {
    const float weight = sums.weights.data[v];
    if (weight > 0) swept.volume.data[v] /= weight;
    swept.mask.data[v] = weight > 0 ? 255 : 0;
  }
  return swept;
}

}  // namespace

template <class T>
SweptVolume reconstructSweep(const SweepFrames<T>& frames, const Progress& progress) {
  checkPoses(frames.poses);
  require(frames.width >= 2 && frames.height >= 2 &&
              frames.pixels.size() ==
                  std::size_t(frames.width) * std::size_t(frames.height) * frames.poses.size(),
          "The sweep has fewer pixels than its pictures need; get a fresh copy.");
  const Geometry g = boxOf(frames);
  Sums sums{Volume<float>(g), Volume<float>(g)};
  parallelFor((g.dims.z + kSlab - 1) / kSlab,
              [&](std::ptrdiff_t s) {
                const Slab slab{int(s * kSlab), int(std::min<std::ptrdiff_t>((s + 1) * kSlab, g.dims.z))};
                for (std::size_t f = 0; f < frames.poses.size(); ++f) {
                  progress.throwIfCancelled();
                  addFrame(frames, f, slab, sums);
                }
              },
              progress.part(0, 0.7));
  SweptVolume swept = meanOf(std::move(sums));
  fillGaps(kFill, swept.volume, swept.mask, progress.part(0.7, 1));
  progress.update(1);
  return swept;
}

template SweptVolume reconstructSweep(const SweepFrames<std::uint8_t>&, const Progress&);
template SweptVolume reconstructSweep(const SweepFrames<float>&, const Progress&);

}  // namespace sonoskin
