#include "core/rbf/compact/neighbourhood.h"

#include <bit>

#include "core/rbf/basis.h"
#include "core/rbf/lane_packer.h"

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
  centre_ = points.position(centre);
  ownNormal_ = {points.nx[centre], points.ny[centre], points.nz[centre]};
  count_ = 0;
  points.grid.forEachRun(centre_, radius, [&](std::size_t first, std::size_t last) {
    reserve(count_ + last - first + LanePacker::kLanes);
    gatherRun(points, first, last, radius * radius);
  });
}

void Neighbourhood::gatherRun(const SortedPoints& points, std::size_t first, std::size_t last, float limit) {
  const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  for (std::size_t i = first; i < last; i += LanePacker::kLanes) {
    const __m256i valid = LanePacker::firstLanes(last - i);
    const auto load = [&](const std::vector<float>& from) {
      return _mm256_maskload_ps(from.data() + i, valid);
    };
    const __m256 x = load(points.x) - centre_.x, y = load(points.y) - centre_.y,
                 z = load(points.z) - centre_.z;
    const __m256 squared = x * x + y * y + z * z;
    const __m256 isNear = _mm256_cmp_ps(squared, _mm256_set1_ps(limit), _CMP_LT_OQ);
    const auto chosen = unsigned(_mm256_movemask_ps(_mm256_and_ps(isNear, _mm256_castsi256_ps(valid))));
    if (chosen == 0) continue;
    const LanePacker packer(chosen);
    packer.pack(x, &dx_[count_]);
    packer.pack(y, &dy_[count_]);
    packer.pack(z, &dz_[count_]);
    packer.pack(squared, &squared_[count_]);
    packer.pack(load(points.nx), &nx_[count_]);
    packer.pack(load(points.ny), &ny_[count_]);
    packer.pack(load(points.nz), &nz_[count_]);
    packer.pack(load(points.influence), &d_[count_]);
    packer.pack(_mm256_add_epi32(_mm256_set1_epi32(int(i)), lane), &index_[count_]);
    count_ += packer.count();
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

void Neighbourhood::select(const Frame& frame, float sigma) {
  const auto along = [](const glm::vec3& axis, __m256 x, __m256 y, __m256 z) {
    return x * axis.x + y * axis.y + z * axis.z;
  };
  std::size_t n = 0;
  for (std::size_t j = 0; j < count_; j += LanePacker::kLanes) {
    const __m256 squared = _mm256_loadu_ps(&squared_[j]);
    const __m256 isNear = _mm256_cmp_ps(squared, _mm256_set1_ps(sigma * sigma), _CMP_LT_OQ);
    const __m256 valid = _mm256_castsi256_ps(LanePacker::firstLanes(count_ - j));
    const LanePacker packer(unsigned(_mm256_movemask_ps(_mm256_and_ps(isNear, valid))));
    const __m256 x = _mm256_loadu_ps(&dx_[j]), y = _mm256_loadu_ps(&dy_[j]), z = _mm256_loadu_ps(&dz_[j]);
    packer.pack(along(frame.u, x, y, z), &u_[n]);
    packer.pack(along(frame.v, x, y, z), &v_[n]);
    packer.pack(along(frame.normal, x, y, z), &w_[n]);
    packer.pack(_mm256_sqrt_ps(squared), &r_[n]);
    packer.pack(_mm256_loadu_ps(&d_[j]), &levelD_[n]);
    packer.pack(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(&index_[j])), &level_[n]);
    n += packer.count();
  }
  selectedCount_ = n;
}

std::size_t Neighbourhood::countWithin(float sigma) const {
  const float limit = sigma * sigma;
  std::size_t n = 0;
  for (std::size_t j = 0; j < count_; ++j) n += squared_[j] < limit;
  return n;
}

}  // namespace sonoskin
