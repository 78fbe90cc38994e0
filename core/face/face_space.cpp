#include "core/face/face_space.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/volume/sample.h"

namespace sonoskin {
namespace {

using glm::vec3;

constexpr float kCellsAcross = 110;  // cells along the diagonal of the points
constexpr float kMargin = 8;         // cells around them

}  // namespace

FaceSpace::FaceSpace(const FaceInput& input) {
  if (input.points.size() == 0) return;
  place(input.points);
  gather(input.points);
  spread();
  if (input.lowPassed) findFree(input);
}

void FaceSpace::place(const SurfacePoints& points) {
  vec3 low(1e30f), high(-1e30f);
  for (const vec3& p : points.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  cell_ = std::max(glm::distance(low, high) / kCellsAcross, 1e-3f);
  inverse_ = 1 / cell_;
  low_ = low - kMargin * cell_;
  dims_ = glm::ivec3((high - low) * inverse_) + 1 + 2 * int(kMargin);
  const std::size_t cells = std::size_t(dims_.x) * std::size_t(dims_.y) * std::size_t(dims_.z);
  nearest_.assign(cells, kNone);
  kinds_.assign(cells, Kind::unknown);
}

void FaceSpace::gather(const SurfacePoints& points) {
  std::vector<float> counts;
  for (std::size_t n = 0; n < points.size(); ++n) {
    std::uint32_t& at = nearest_[std::size_t(indexOf(points.positions[n]))];
    if (at == kNone) {
      at = std::uint32_t(surfels_.size());
      surfels_.push_back({vec3(0), vec3(0)});
      counts.push_back(0);
    }
    surfels_[at].place += points.positions[n];
    surfels_[at].normal += points.normals[n];
    ++counts[at];
  }
  for (std::size_t s = 0; s < surfels_.size(); ++s) {
    surfels_[s].place /= counts[s];
    const float length = glm::length(surfels_[s].normal);
    surfels_[s].normal = length > 0 ? surfels_[s].normal / length : vec3(0);  // two sides that meet: no normal
  }
}

// Each cell asks its six neighbours for their surfel, forward and back, twice.
void FaceSpace::spread() {
  const std::ptrdiff_t steps[3] = {1, dims_.x, std::ptrdiff_t(dims_.x) * dims_.y};
  const float reach = kReach * cell_ * kReach * cell_;
  std::vector<float> squares(nearest_.size(), 1e30f);
  const auto visit = [&](int i, int j, int k, int way) {
    const std::ptrdiff_t at = (std::ptrdiff_t(k) * dims_.y + j) * dims_.x + i;
    const vec3 centre = centreOf(i, j, k);
    const int here[3] = {i, j, k};
    const auto offer = [&](std::uint32_t surfel) {
      const vec3 apart = surfels_[surfel].place - centre;
      const float square = glm::dot(apart, apart);
      if (square >= squares[std::size_t(at)] || square > reach) return;
      squares[std::size_t(at)] = square;
      nearest_[std::size_t(at)] = surfel;
    };
    if (nearest_[std::size_t(at)] != kNone) offer(nearest_[std::size_t(at)]);
    for (int axis = 0; axis < 3; ++axis) {
      const int to = here[axis] + way;
      if (to < 0 || to >= dims_[axis]) continue;
      const std::uint32_t surfel = nearest_[std::size_t(at + way * steps[axis])];
      if (surfel != kNone) offer(surfel);
    }
  };
  for (int pass = 0; pass < 4; ++pass) {
    const bool back = pass % 2 == 1;
    for (int c = 0; c < dims_.z; ++c)
      for (int b = 0; b < dims_.y; ++b)
        for (int a = 0; a < dims_.x; ++a)
          back ? visit(dims_.x - 1 - a, dims_.y - 1 - b, dims_.z - 1 - c, 1) : visit(a, b, c, -1);
  }
}

// From the far end of the beams to the near one: a dark cell is free if the next one along its beam is free, or holds
// a surface that faces the probe.
void FaceSpace::findFree(const FaceInput& input) {
  const Geometry& g = input.lowPassed->geometry;
  std::vector<std::uint32_t> order(nearest_.size());
  std::vector<float> depth(nearest_.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto cellOf = [&](std::uint32_t at) {
    const int i = int(at) % dims_.x, jk = int(at) / dims_.x;
    return centreOf(i, jk % dims_.y, jk / dims_.y);
  };
  for (std::uint32_t at : order) {
    const glm::dvec3 c(cellOf(at));
    depth[at] = float(input.beam.apex ? glm::distance(c, *input.beam.apex) : glm::dot(c, input.beam.axis));
  }
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return depth[a] > depth[b]; });
  for (std::uint32_t at : order) {
    const vec3 centre = cellOf(at);
    const vec3 index(g.toIndex(glm::dvec3(centre)));
    if (glm::any(glm::lessThan(index, vec3(0))) || glm::any(glm::greaterThan(index, vec3(g.dims - 1)))) continue;
    if (sampleTrilinear(*input.lowPassed, index) >= input.fluid) continue;
    const vec3 along(input.beam.directionAt(glm::dvec3(centre)));
    const vec3 next = centre + cell_ * along;
    const Surfel* skin = nearest(next);
    const bool meets = skin && glm::dot(skin->normal, along) < -0.2f &&
                       glm::distance(skin->place, next) < 1.2f * cell_;
    kinds_[at] = meets || kind(next) == Kind::free ? Kind::free : Kind::dark;
  }
}

}  // namespace sonoskin
