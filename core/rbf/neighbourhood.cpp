#include "core/rbf/neighbourhood.h"

#include <bit>

#include "core/rbf/basis.h"

namespace sonoskin {
namespace {

// k with 2^(k-1) <= ratio < 2^k for ratio >= 1, else 0: read from the exponent of the float.
std::uint32_t levelOf(float ratio) {
  constexpr int kBias = 126, kMantissaBits = 23;
  const int k = int(std::bit_cast<std::uint32_t>(ratio) >> kMantissaBits) - kBias;
  return std::uint32_t(k < 0 ? 0 : k);
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
  const float limit = radius * radius;
  const float *x = points.x.data(), *y = points.y.data(), *z = points.z.data();
  std::size_t n = 0;
  points.grid.forEachRun(c, radius, [&](std::size_t first, std::size_t last) {
    reserve(n + last - first);
    std::uint32_t* index = index_.data();
    float* squared = squared_.data();
    for (std::size_t i = first; i < last;
         ++i) {  // every point is written, only near ones are kept: no branch
      const float dx = x[i] - c.x, dy = y[i] - c.y, dz = z[i] - c.z;
      squared[n] = dx * dx + dy * dy + dz * dz;
      index[n] = std::uint32_t(i);
      n += squared[n] < limit;
    }
  });
  count_ = n;
  copyAttributes(points, c);
}

void Neighbourhood::copyAttributes(const SortedPoints& points, const glm::vec3& centre) {
  const std::uint32_t* index = index_.data();
  const auto copy = [&](const std::vector<float>& from, float subtract, std::vector<float>& to) {
    const float* in = from.data();
    float* out = to.data();
#pragma omp simd
    for (std::size_t j = 0; j < count_; ++j) out[j] = in[index[j]] - subtract;
  };
  copy(points.x, centre.x, dx_);
  copy(points.y, centre.y, dy_);
  copy(points.z, centre.z, dz_);
  copy(points.nx, 0, nx_);
  copy(points.ny, 0, ny_);
  copy(points.nz, 0, nz_);
  copy(points.influence, 0, d_);
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
  const float *dx = dx_.data(), *dy = dy_.data(), *dz = dz_.data(), *squared = squared_.data(),
              *d = d_.data();
  std::uint32_t* level = level_.data();
  levelEnd_.fill(0);
  for (std::size_t j = 0; j < count_; ++j) {
    level[j] = std::min(levelOf(squared[j] * scale), std::uint32_t(kLevels - 1));
    ++levelEnd_[level[j] + 1];
  }
  for (std::size_t k = 0; k < kLevels; ++k) levelEnd_[k + 1] += levelEnd_[k];
  std::array<std::size_t, kLevels + 1> next = levelEnd_;
  const glm::vec3 eu = frame.u, ev = frame.v, en = frame.normal;
  float *u = u_.data(), *v = v_.data(), *w = w_.data(), *r = r_.data(), *levelD = levelD_.data();
  for (std::size_t j = 0; j < count_; ++j) {
    const std::size_t to = next[level[j]]++;
    u[to] = dx[j] * eu.x + dy[j] * eu.y + dz[j] * eu.z;
    v[to] = dx[j] * ev.x + dy[j] * ev.y + dz[j] * ev.z;
    w[to] = dx[j] * en.x + dy[j] * en.y + dz[j] * en.z;
    r[to] = std::sqrt(squared[j]);
    levelD[to] = d[j];
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
