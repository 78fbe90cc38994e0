#include "core/rbf/neighbourhood.h"

#include <bit>

#include "core/rbf/basis.h"

namespace sonoskin {
namespace {

// k with 2^(k-1) <= ratio < 2^k for ratio >= 1, else 0: read from the exponent of the float.
std::uint8_t levelOf(float ratio) {
  constexpr int kBias = 126, kMantissaBits = 23;
  const int k = int(std::bit_cast<std::uint32_t>(ratio) >> kMantissaBits) - kBias;
  return std::uint8_t(k < 0 ? 0 : k);
}

}  // namespace

void Neighbourhood::reserve(std::size_t count) {
  if (count <= index_.size()) return;
  const std::size_t capacity = 2 * count;
  index_.resize(capacity);
  level_.resize(capacity);
  for (auto* array : {&dx_, &dy_, &dz_, &squared_, &nx_, &ny_, &nz_, &d_, &u_, &v_, &w_, &r_, &levelD_})
    array->resize(capacity);
}

void Neighbourhood::gather(const SortedPoints& points, std::size_t centre, float radius) {
  const glm::vec3 c = points.position(centre);
  ownNormal_ = {points.nx[centre], points.ny[centre], points.nz[centre]};
  std::size_t n = 0;
  points.grid.forEachRun(c, radius, [&](std::size_t first, std::size_t last) {
    reserve(n + last - first);
    for (std::size_t i = first; i < last;
         ++i) {  // every point is written, only near ones are kept: no branch
      const float dx = points.x[i] - c.x, dy = points.y[i] - c.y, dz = points.z[i] - c.z;
      const float squared = dx * dx + dy * dy + dz * dz;
      index_[n] = std::uint32_t(i);
      dx_[n] = dx, dy_[n] = dy, dz_[n] = dz, squared_[n] = squared;
      n += squared < radius * radius;
    }
  });
  count_ = n;
  copyAttributes(points);
}

void Neighbourhood::copyAttributes(const SortedPoints& points) {
  for (std::size_t j = 0; j < count_; ++j) {
    const std::uint32_t i = index_[j];
    nx_[j] = points.nx[i], ny_[j] = points.ny[i], nz_[j] = points.nz[i], d_[j] = points.influence[i];
  }
}

glm::vec3 Neighbourhood::meanNormal(float sigma) const {
  const float inverse = 1 / sigma;
  const glm::vec3 own = ownNormal_;
  const float *nx = nx_.data(), *ny = ny_.data(), *nz = nz_.data(), *d = d_.data(),
              *squared = squared_.data();
  float x = 0, y = 0, z = 0;
#pragma omp simd reduction(+ : x, y, z)
  for (std::size_t j = 0; j < count_; ++j) {
    const float weight = wendland(std::sqrt(squared[j]) * inverse) * d[j];
    const float gated = nx[j] * own.x + ny[j] * own.y + nz[j] * own.z > 0 ? weight : 0;
    x += gated * nx[j], y += gated * ny[j], z += gated * nz[j];
  }
  const glm::vec3 sum(x, y, z);
  const float length = glm::length(sum);
  return length > 1e-12f ? sum / length : own;
}

void Neighbourhood::project(const Frame& frame, float smallest) {
  smallest_ = smallest;
  const float scale = 1 / (smallest * smallest);
  levelEnd_.fill(0);
  for (std::size_t j = 0; j < count_; ++j) {
    level_[j] = std::min(levelOf(squared_[j] * scale), std::uint8_t(kLevels - 1));
    ++levelEnd_[level_[j] + 1u];
  }
  for (std::size_t k = 0; k < kLevels; ++k) levelEnd_[k + 1] += levelEnd_[k];
  std::array<std::size_t, kLevels + 1> next = levelEnd_;
  const glm::vec3 u = frame.u, v = frame.v, n = frame.normal;
  for (std::size_t j = 0; j < count_; ++j) {
    const std::size_t to = next[level_[j]]++;
    const float dx = dx_[j], dy = dy_[j], dz = dz_[j];
    u_[to] = dx * u.x + dy * u.y + dz * u.z;
    v_[to] = dx * v.x + dy * v.y + dz * v.z;
    w_[to] = dx * n.x + dy * n.y + dz * n.z;
    r_[to] = std::sqrt(squared_[j]);
    levelD_[to] = d_[j];
  }
}

LocalSamples Neighbourhood::within(float sigma) const {
  // Just below sigma, so that the limit of a level does not take the next one too; φ is 0 there anyway.
  constexpr float kBelow = 0.99999f;
  const float ratio = sigma / smallest_;
  const std::size_t level = std::min<std::size_t>(levelOf(ratio * ratio * kBelow), kLevels - 1);
  return {u_.data(), v_.data(), w_.data(), r_.data(), levelD_.data(), levelEnd_[level + 1]};
}

std::size_t Neighbourhood::countWithin(float sigma) const {
  const float limit = sigma * sigma;
  std::size_t n = 0;
  for (std::size_t j = 0; j < count_; ++j) n += squared_[j] < limit;
  return n;
}

}  // namespace sonoskin
