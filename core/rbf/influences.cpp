#include "core/rbf/influences.h"

#include <limits>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr std::ptrdiff_t kPointsPerTask = 1024;
constexpr float kSmallestInfluence = 1e-4f;

// The K smallest values seen, in ascending order.
class SmallestValues {
 public:
  explicit SmallestValues(std::size_t count) : values_(count) {}
  void clear() { std::fill(values_.begin(), values_.end(), std::numeric_limits<float>::infinity()); }
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

// Squared distances from sorted point `self` to its K nearest others.
void findNearest(const std::vector<glm::vec3>& positions, std::size_t self, const PointGrid& grid,
                 float radius, SmallestValues& nearest) {
  const glm::vec3 p = positions[self];
  for (;; radius *= 1.5f) {
    nearest.clear();
    grid.forEachRun(p, radius, [&](std::size_t first, std::size_t last) {
      for (std::size_t j = first; j < last; ++j) {
        const glm::vec3 d = positions[j] - p;
        const float squared = glm::dot(d, d);
        if (squared < nearest.largest() && j != self) nearest.add(squared);
      }
    });
    if (nearest.largest() <= radius * radius) return;
  }
}

}  // namespace

std::vector<float> influences(const std::vector<glm::vec3>& positions, const std::vector<float>& confidence,
                              const PointGrid& grid, double spacing, int neighbours,
                              const Progress& progress) {
  const auto count = std::ptrdiff_t(positions.size());
  const auto k = std::size_t(std::min<std::ptrdiff_t>(neighbours, count - 1));
  const auto scale = float(1 / (spacing * spacing));
  std::vector<float> result(positions.size());
  parallelFor((count + kPointsPerTask - 1) / kPointsPerTask,
              [&](std::ptrdiff_t task) {
                SmallestValues nearest(k);
                const auto last = std::size_t(std::min(count, (task + 1) * kPointsPerTask));
                for (auto i = std::size_t(task * kPointsPerTask); i < last; ++i) {
                  findNearest(positions, i, grid, float(2.2 * spacing), nearest);
                  result[i] = confidence[i] * std::max(kSmallestInfluence, nearest.sum() * scale);
                }
              },
              progress);
  return result;
}

}  // namespace sonoskin
