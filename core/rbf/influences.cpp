#include "core/rbf/influences.h"

#include <algorithm>
#include <limits>
#include <span>

#include "core/base/parallel_blocks.h"
#include "core/rbf/lane_packer.h"
#include "core/rbf/sorted_points.h"

namespace sonoskin {
namespace {

constexpr std::size_t kPointsPerTask = 1024;
constexpr float kSmallestInfluence = 1e-4f;
constexpr double kFirstRadius = 2.2;  // spacings

// The K smallest values seen, in ascending order.
class SmallestValues {
 public:
  explicit SmallestValues(std::size_t count) : values_(count) {}
  void clear() { std::fill(values_.begin(), values_.end(), std::numeric_limits<float>::infinity()); }
  std::size_t size() const { return values_.size(); }
  float largest() const { return values_.back(); }
  void add(float value) {
    std::size_t i = values_.size() - 1;
    for (; i > 0 && values_[i - 1] > value; --i) values_[i] = values_[i - 1];
    values_[i] = value;
  }
  float sum() const {
    float s = 0;
    for (const float v : values_) s += v;
    return s;
  }

 private:
  std::vector<float> values_;
};

// Squared distances from one sorted point to the others around it.
class Distances {
 public:
  void find(const SortedPoints& points, std::size_t self, float radius) {
    count_ = 0;
    points.grid.forEachRun(points.position(self), radius, [&](std::size_t first, std::size_t last) {
      squared_.resize(std::max(squared_.size(), count_ + last - first + LanePacker::kLanes));
      // Two runs around the point itself, which is not its own neighbour.
      if (self < first || self >= last) return addRun(points, self, first, last, radius * radius);
      addRun(points, self, first, self, radius * radius);
      addRun(points, self, self + 1, last, radius * radius);
    });
  }
  std::span<const float> values() const { return {squared_.data(), count_}; }

 private:
  void addRun(const SortedPoints& points, std::size_t self, std::size_t first, std::size_t last,
              float limit) {
    for (std::size_t i = first; i < last; i += LanePacker::kLanes) {
      const __m256i valid = LanePacker::firstLanes(last - i);
      const __m256 x = _mm256_maskload_ps(points.x.data() + i, valid) - points.x[self];
      const __m256 y = _mm256_maskload_ps(points.y.data() + i, valid) - points.y[self];
      const __m256 z = _mm256_maskload_ps(points.z.data() + i, valid) - points.z[self];
      const __m256 squared = x * x + y * y + z * z;
      const __m256 isNear = _mm256_cmp_ps(squared, _mm256_set1_ps(limit), _CMP_LE_OQ);
      const LanePacker packer(
          unsigned(_mm256_movemask_ps(_mm256_and_ps(isNear, _mm256_castsi256_ps(valid)))));
      packer.pack(squared, &squared_[count_]);
      count_ += packer.count();
    }
  }

  std::vector<float> squared_;
  std::size_t count_ = 0;
};

// Sum of the K smallest squared distances from a sorted point to others.
float sumOfNearest(const SortedPoints& points, std::size_t self, Distances& distances,
                   SmallestValues& nearest) {
  for (auto radius = float(kFirstRadius * points.spacing);; radius *= 1.5f) {
    distances.find(points, self, radius);
    if (distances.values().size() < nearest.size()) continue;
    nearest.clear();
    for (const float squared : distances.values())
      if (squared < nearest.largest()) nearest.add(squared);
    return nearest.sum();
  }
}

}  // namespace

std::vector<float> influences(const SortedPoints& points, const std::vector<float>& confidence,
                              int neighbours, const Progress& progress) {
  const auto k = std::size_t(std::min<std::ptrdiff_t>(neighbours, std::ptrdiff_t(points.size()) - 1));
  const auto scale = float(1 / (points.spacing * points.spacing));
  std::vector<float> result(points.size());
  parallelBlocks(
      points.size(), kPointsPerTask,
      [&](std::size_t first, std::size_t end) {
        SmallestValues nearest(k);
        Distances distances;
        for (std::size_t i = first; i < end; ++i)
          result[i] = confidence[i] *
                      std::max(kSmallestInfluence, sumOfNearest(points, i, distances, nearest) * scale);
      },
      progress);
  return result;
}

}  // namespace sonoskin
