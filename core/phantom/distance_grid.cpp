#include "core/phantom/distance_grid.h"

#include <cmath>
#include <utility>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr int kBlock = 8;
constexpr double kLipschitz = 1.25;

struct Block {
  glm::ivec3 begin, end;
};

void fillBlock(Volume<float>& grid, const Block& block, const DistanceFunction& distance, double band) {
  const glm::dvec3 low = grid.geometry.toWorld(block.begin), high = grid.geometry.toWorld(block.end - 1);
  const double middle = distance(0.5 * (low + high));
  const bool far = std::abs(middle) > band + kLipschitz * 0.5 * glm::distance(low, high);
  for (int k = block.begin.z; k < block.end.z; ++k)
    for (int j = block.begin.y; j < block.end.y; ++j)
      for (int i = block.begin.x; i < block.end.x; ++i)
        grid.at(i, j, k) = float(far ? middle : distance(grid.geometry.toWorld({i, j, k})));
}

}  // namespace

Volume<float> sampleDistance(const Geometry& geometry, const DistanceFunction& distance, double band,
                             const Progress& progress) {
  Volume<float> grid(geometry);
  const glm::ivec3 blocks = (geometry.dims + (kBlock - 1)) / kBlock;
  parallelFor(
      std::ptrdiff_t(blocks.y) * blocks.z,
      [&](std::ptrdiff_t column) {
        for (int b = 0; b < blocks.x; ++b) {
          const glm::ivec3 begin = kBlock * glm::ivec3(b, int(column % blocks.y), int(column / blocks.y));
          fillBlock(grid, {begin, glm::min(begin + kBlock, geometry.dims)}, distance, band);
        }
      },
      progress);
  return grid;
}

DistanceGrid::DistanceGrid(Volume<float> samples)
    : samples_(std::move(samples)),
      origin_(samples_.geometry.origin),
      scale_(1.0 / samples_.geometry.spacing),
      last_(samples_.geometry.dims - 1),
      row_(samples_.geometry.dims.x),
      plane_(row_ * samples_.geometry.dims.y) {}

DistanceGrid::Cell DistanceGrid::cellAt(const glm::vec3& world) const {
  const glm::vec3 index = glm::clamp((world - origin_) * scale_, glm::vec3(0), last_);
  const glm::ivec3 base(glm::min(index, last_ - 1.f));
  return {samples_.data.data() + base.z * plane_ + base.y * row_ + base.x, index - glm::vec3(base)};
}

float DistanceGrid::value(const glm::vec3& world) const {
  const auto [c, t] = cellAt(world);
  const auto alongX = [&](const float* v) { return v[0] + t.x * (v[1] - v[0]); };
  const auto alongY = [&](const float* v) { return alongX(v) + t.y * (alongX(v + row_) - alongX(v)); };
  return alongY(c) + t.z * (alongY(c + plane_) - alongY(c));
}

DistanceSample DistanceGrid::sample(const glm::vec3& world) const {
  const auto [c, t] = cellAt(world);
  const auto mix = [](float a, float b, float s) { return a + s * (b - a); };
  const float *c00 = c, *c10 = c + row_, *c01 = c + plane_, *c11 = c + plane_ + row_;
  const float x00 = mix(c00[0], c00[1], t.x), x10 = mix(c10[0], c10[1], t.x);
  const float x01 = mix(c01[0], c01[1], t.x), x11 = mix(c11[0], c11[1], t.x);
  const float y0 = mix(x00, x10, t.y), y1 = mix(x01, x11, t.y);
  const glm::vec3 slope{
      mix(mix(c00[1] - c00[0], c10[1] - c10[0], t.y), mix(c01[1] - c01[0], c11[1] - c11[0], t.y), t.z),
      mix(x10 - x00, x11 - x01, t.z), y1 - y0};
  return {mix(y0, y1, t.z), slope * scale_};
}

}  // namespace sonoskin
