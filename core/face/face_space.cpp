#include "core/face/face_space.h"

#include <algorithm>
#include <cmath>

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
  dropStrays();
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
    surfels_[s].normal =
        length > 0 ? surfels_[s].normal / length : vec3(0);  // two sides that meet: no normal
  }
}

// A surface passes through many of the cells around one of its own; a stray point is alone.
void FaceSpace::dropStrays() {
  constexpr int kCompany = 4;
  const std::vector<std::uint32_t> held = nearest_;
  for (std::size_t s = 0; s < surfels_.size(); ++s) {
    const std::ptrdiff_t at = indexOf(surfels_[s].place);
    int company = 0;
    for (int n = 0; n < 27; ++n) {
      const std::ptrdiff_t aside =
          (std::ptrdiff_t(n / 9 - 1) * dims_.y + (n / 3 % 3 - 1)) * dims_.x + (n % 3 - 1);
      company += held[std::size_t(at + aside)] != kNone;
    }
    if (company < kCompany) nearest_[std::size_t(at)] = kNone;
  }
  std::vector<Surfel> kept;
  for (std::uint32_t& at : nearest_) {
    if (at == kNone) continue;
    kept.push_back(surfels_[at]);
    at = std::uint32_t(kept.size() - 1);
  }
  surfels_ = std::move(kept);
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

// From the far end of the beams to the near one, plane by plane: a dark cell is free if the next one along its beam is
// free, or holds a surface that faces the probe.
void FaceSpace::findFree(const FaceInput& input) {
  const vec3 axis(input.beam.axis), size = glm::abs(axis);
  const int a = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int b = (a + 1) % 3, c = (a + 2) % 3;
  glm::ivec3 cell;
  for (int plane = 0; plane < dims_[a]; ++plane) {
    cell[a] = axis[a] > 0 ? dims_[a] - 1 - plane : plane;
    for (cell[b] = 0; cell[b] < dims_[b]; ++cell[b])
      for (cell[c] = 0; cell[c] < dims_[c]; ++cell[c]) {
        const vec3 centre = centreOf(cell.x, cell.y, cell.z);
        const vec3 along(input.beam.directionAt(glm::dvec3(centre)));
        const vec3 next = centre + along * (cell_ / std::max(std::abs(along[a]), 0.3f));
        kinds_[std::size_t(indexOf(centre))] = kindOf(input, centre, along, next);
      }
  }
}

FaceSpace::Kind FaceSpace::kindOf(const FaceInput& input, const vec3& centre, const vec3& along,
                                  const vec3& next) const {
  const Geometry& g = input.lowPassed->geometry;
  const vec3 index(g.toIndex(glm::dvec3(centre)));
  if (glm::any(glm::lessThan(index, vec3(0))) || glm::any(glm::greaterThan(index, vec3(g.dims - 1))))
    return Kind::unknown;
  if (sampleTrilinear(*input.lowPassed, index) >= input.fluid) return Kind::unknown;
  if (kind(next) == Kind::free) return Kind::free;
  const Surfel* skin = nearest(next);
  const bool meets =
      skin && glm::dot(skin->normal, along) < -0.2f && glm::distance(skin->place, next) < 1.2f * cell_;
  return meets ? Kind::free : Kind::dark;
}

}  // namespace sonoskin
