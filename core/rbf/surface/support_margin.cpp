#include "core/rbf/surface/support_margin.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

constexpr float kRadius = 5;       // spacings
constexpr float kSameSide = 0.3f;  // cosine between the normals of points and surface
constexpr float kDensityBand =
    0.6f;  // what a share of the density counts as: 0.3 more than the limit is safe

}  // namespace

SupportMargin::SupportMargin(const SurfacePoints& points, const SupportLimits& limits)
    : limits_(limits),
      radius_(limits.density > 0 ? kRadius * limits.spacing : 0),
      farthest_(std::max(radius_, (1 + kBand) * limits.gap)),
      grid_(points.positions, 2.2f * limits.spacing) {
  positions_.reserve(points.size());
  normals_.reserve(points.size());
  for (const std::uint32_t i : grid_.order()) {
    positions_.push_back(points.positions[i]);
    normals_.push_back(points.normals[i]);
  }
  if (limits.density > 0) findUsualDensity();
}

// A few thousand points tell the median.
void SupportMargin::findUsualDensity() {
  constexpr std::size_t kPoints = 2000;
  const std::size_t step = std::max<std::size_t>(positions_.size() / kPoints, 1);
  std::vector<float> densities;
  Nearby nearby;
  for (std::size_t i = 0; i < positions_.size(); i += step) {
    gather(positions_[i], 0, nearby);
    densities.push_back(sumsAt(positions_[i], normals_[i], nearby).density);
  }
  if (densities.empty()) return;
  const auto middle = densities.begin() + std::ptrdiff_t(densities.size() / 2);
  std::nth_element(densities.begin(), middle, densities.end());
  usual_ = *middle;
}

void SupportMargin::Nearby::makeRoom(std::size_t more) {
  if (count + more <= x.size()) return;
  for (std::vector<float>* v : {&x, &y, &z, &nx, &ny, &nz}) v->resize(2 * (count + more));
}

void SupportMargin::gather(const glm::vec3& centre, float reach, Nearby& nearby) const {
  const float radius = farthest_ + reach;
  nearby.count = 0;
  grid_.forEachRun(centre, radius, [&](std::size_t first, std::size_t last) {
    nearby.makeRoom(last - first);
    for (std::size_t i = first; i < last; ++i) {  // writes all, and keeps what is near enough
      const glm::vec3 p = positions_[i], n = normals_[i], d = p - centre;
      const std::size_t at = nearby.count;
      nearby.x[at] = p.x, nearby.y[at] = p.y, nearby.z[at] = p.z;
      nearby.nx[at] = n.x, nearby.ny[at] = n.y, nearby.nz[at] = n.z;
      nearby.count += glm::dot(d, d) < radius * radius;
    }
  });
}

SupportMargin::Sums SupportMargin::sumsAt(const glm::vec3& position, const glm::vec3& normal,
                                          const Nearby& nearby) const {
  const float scale = radius_ > 0 ? 1 / (radius_ * radius_) : 0;
  const float px = position.x, py = position.y, pz = position.z, ux = normal.x, uy = normal.y, uz = normal.z;
  const float *x = nearby.x.data(), *y = nearby.y.data(), *z = nearby.z.data();
  const float *nx = nearby.nx.data(), *ny = nearby.ny.data(), *nz = nearby.nz.data();
  float sum = 0, nearest = farthest_ * farthest_;
#pragma omp simd reduction(+ : sum) reduction(min : nearest)
  for (std::size_t i = 0; i < nearby.count; ++i) {
    const float dx = x[i] - px, dy = y[i] - py, dz = z[i] - pz;
    const float squared = dx * dx + dy * dy + dz * dz;
    nearest = squared < nearest ? squared : nearest;
    const float rest = 1 - squared * scale;
    const float cosine = nx[i] * ux + ny[i] * uy + nz[i] * uz;
    sum += rest > 0 && cosine > kSameSide ? rest * rest : 0.f;
  }
  return {sum, std::sqrt(nearest)};
}

SupportMargin::Place SupportMargin::at(const glm::vec3& position, const glm::vec3& normal, float coverage,
                                       const Nearby& nearby) const {
  const Sums sums = sumsAt(position, normal, nearby);
  const float near = (limits_.gap - sums.distance) / limits_.gap;
  const float covered = limits_.coverage > 0 ? (coverage - limits_.coverage) / limits_.coverage : kBand;
  const float dense = limits_.density > 0 ? (sums.density / usual_ - limits_.density) / kDensityBand : kBand;
  return {std::clamp(std::min({near, covered, dense}), -kBand, kBand), near <= 0 || covered <= 0};
}

bool SupportMargin::mayStay(const glm::vec3& centre, float reach) const {
  const float radius = (1 + kBand) * limits_.gap + reach;
  bool found = false;
  for (const float r : {std::min(radius, limits_.spacing), radius}) {  // most have a point within a spacing
    grid_.forEachRun(centre, r, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last && !found; ++i) {
        const glm::vec3 d = positions_[i] - centre;
        found = glm::dot(d, d) < r * r;
      }
    });
    if (found) break;
  }
  return found;
}

}  // namespace sonoskin
