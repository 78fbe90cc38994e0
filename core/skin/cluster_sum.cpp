#include "core/skin/cluster_sum.h"

#include <immintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/base/perpendicular.h"
#include "core/skin/diffusion_target.h"

namespace sonoskin {
namespace {

constexpr std::size_t kLanes = ClusterSum::kLanes;

__m256 all(float value) { return _mm256_set1_ps(value); }

// 2^x for x from -126 to 0, to 3e-6 of it: the nearest whole power, and a polynomial of what is left.
__m256 powerOfTwo(__m256 x) {
  const __m256 whole = _mm256_round_ps(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC), rest = x - whole;
  __m256 power = all(9.6663685e-3f) * rest + all(5.5921976e-2f);
  power = power * rest + all(2.4022349e-1f);
  power = power * rest + all(6.9312105e-1f);
  power = power * rest + all(1.f);
  const __m256i shift = _mm256_slli_epi32(_mm256_cvtps_epi32(whole), 23);
  return _mm256_castsi256_ps(_mm256_add_epi32(_mm256_castps_si256(power), shift));
}

struct Three {
  __m256 x, y, z;

  friend __m256 dot(const Three& a, const Three& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};

struct Colour {
  __m256 r = all(0), g = all(0), b = all(0), a = all(0);

  void add(__m256 weight, const glm::vec4& light) {
    r += weight * all(light.r);
    g += weight * all(light.g);
    b += weight * all(light.b);
    a += weight * all(light.a);
  }
};

// The first `count` of eight vectors, the last one again for the others.
Three transposed(std::span<const glm::vec3> of) {
  std::array<std::array<float, kLanes>, 3> axes;
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    for (int axis = 0; axis < 3; ++axis)
      axes[std::size_t(axis)][lane] = of[std::min(lane, of.size() - 1)][axis];
  return {_mm256_loadu_ps(axes[0].data()), _mm256_loadu_ps(axes[1].data()), _mm256_loadu_ps(axes[2].data())};
}

void store(const Colour& colour, std::size_t count, glm::vec4* to) {
  std::array<std::array<float, kLanes>, 4> c;
  _mm256_storeu_ps(c[0].data(), colour.r);
  _mm256_storeu_ps(c[1].data(), colour.g);
  _mm256_storeu_ps(c[2].data(), colour.b);
  _mm256_storeu_ps(c[3].data(), colour.a);
  for (std::size_t lane = 0; lane < count; ++lane)
    to[lane] = {c[0][lane], c[1][lane], c[2][lane], c[3][lane]};
}

}  // namespace

// Eight: the places and their sums.
//   side, up      tangents over the reach, of planes
//   light, along, across   of light, and of light times the place along either tangent
//   u ... vv      of those places and their products
struct ClusterSum::Eight {
  Three position, normal, side, up;
  glm::vec3 low, high;
  __m256 weight = all(0), u = all(0), v = all(0), uu = all(0), uv = all(0), vv = all(0);
  Colour light, along, across;

  Eight(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals)
      : position(transposed(positions)), normal(transposed(normals)), low(positions[0]), high(positions[0]) {
    for (const glm::vec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
  }
  void layPlanes(std::span<const glm::vec3> normals, float reach) {
    std::array<glm::vec3, kLanes> sides, ups;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      sides[i] = perpendicularTo<0, 1>(normals[i], 0.7) / reach;
      ups[i] = glm::cross(normals[i], sides[i]);
    }
    side = transposed(std::span(sides.data(), normals.size()));
    up = transposed(std::span(ups.data(), normals.size()));
  }
  void addPlace(__m256 w, const Three& away, const glm::vec4& carried) {
    const __m256 a = dot(away, side), b = dot(away, up), wa = w * a, wb = w * b;
    u += wa, v += wb;
    uu += wa * a, uv += wa * b, vv += wb * b;
    along.add(wa, carried);
    across.add(wb, carried);
  }
  Colour mean() const { return {light.r / weight, light.g / weight, light.b / weight, light.a / weight}; }
  Colour planes() const;
};

// The plane that fits the light around a place best, near clusters counting more. A little of its slope is held back, so
// that clusters on one side alone are not continued too far.
Colour ClusterSum::Eight::planes() const {
  constexpr float kHeldBack = 0.003f;
  const __m256 a = u / weight, b = v / weight, held = all(kHeldBack) * weight;
  const __m256 suu = uu - u * a + held, suv = uv - u * b, svv = vv - v * b + held;
  const __m256 byDet = all(1) / (suu * svv - suv * suv);
  const auto value = [&](__m256 l, __m256 lu, __m256 lv) {
    const __m256 cu = lu - l * a, cv = lv - l * b;
    return l / weight - byDet * ((svv * cu - suv * cv) * a + (suu * cv - suv * cu) * b);
  };
  return {value(light.r, along.r, across.r), value(light.g, along.g, across.g),
          value(light.b, along.b, across.b), value(light.a, along.a, across.a)};
}

ClusterSum::ClusterSum(const AreaPoints& clusters, double reach, double variance, bool readsPlane)
    : grid_(clusters.positions, float(reach)),
      reach_(float(reach)),
      exponent_(float(-0.5 * std::numbers::log2e / variance)),
      readsPlane_(readsPlane) {
  constexpr float kFarAway = 1e15f;
  const std::size_t count = clusters.size();
  for (std::vector<float>* axis : {&x_, &y_, &z_}) axis->assign(count + kLanes, kFarAway);
  for (std::vector<float>* axis : {&nx_, &ny_, &nz_, &area_}) axis->assign(count + kLanes, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t from = order()[i];
    const glm::vec3 &p = clusters.positions[from], &n = clusters.normals[from];
    x_[i] = p.x, y_[i] = p.y, z_[i] = p.z;
    nx_[i] = n.x, ny_[i] = n.y, nz_[i] = n.z;
    area_[i] = clusters.areas[from];
  }
}

// A bit for each of the clusters from `first` to `last`, eight at most, that are within reach of the places' box.
std::uint32_t ClusterSum::withinReach(const Eight& eight, std::size_t first, std::size_t last) const {
  const auto gap = [&](const std::vector<float>& of, float low, float high) {
    const __m256 at = _mm256_loadu_ps(&of[first]);
    return _mm256_max_ps(_mm256_max_ps(all(low) - at, at - all(high)), all(0));
  };
  const __m256 x = gap(x_, eight.low.x, eight.high.x), y = gap(y_, eight.low.y, eight.high.y),
               z = gap(z_, eight.low.z, eight.high.z);
  const __m256 isNear = _mm256_cmp_ps(x * x + y * y + z * z, all(reach_ * reach_), _CMP_LT_OQ);
  const std::uint32_t valid = last - first >= kLanes ? 0xFFu : (1u << (last - first)) - 1;
  return std::uint32_t(_mm256_movemask_ps(isNear)) & valid;
}

template <bool kPlane>
void ClusterSum::add(Eight& eight, std::span<const glm::vec4> light) const {
  const glm::vec3 middle = 0.5f * (eight.low + eight.high);
  const __m256 limit = all(reach_ * reach_), exponent = all(exponent_), gate = all(kLocalCosine);
  const auto addCluster = [&](std::size_t i) {
    const Three away{all(x_[i]) - eight.position.x, all(y_[i]) - eight.position.y,
                     all(z_[i]) - eight.position.z};
    const __m256 squared = dot(away, away);
    const __m256 cosine = dot(eight.normal, {all(nx_[i]), all(ny_[i]), all(nz_[i])});
    const __m256 counts =
        _mm256_and_ps(_mm256_cmp_ps(squared, limit, _CMP_LT_OQ), _mm256_cmp_ps(cosine, gate, _CMP_GT_OQ));
    // Far lanes weigh nothing, but their powers must stay numbers.
    const __m256 power = powerOfTwo(_mm256_max_ps(exponent * squared, all(-100)));
    const __m256 weight = _mm256_and_ps(counts, power * all(area_[i]));
    eight.weight += weight;
    eight.light.add(weight, light[i]);
    if constexpr (kPlane) eight.addPlace(weight, away, light[i]);
  };
  grid_.forEachRun(middle, reach_ + 0.5f * glm::distance(eight.low, eight.high),
                   [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; i += kLanes)
                       for (std::uint32_t near = withinReach(eight, i, last); near; near &= near - 1)
                         addCluster(i + std::size_t(std::countr_zero(near)));
                   });
}

void ClusterSum::meansAt(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                         std::span<const glm::vec4> light, glm::vec4* means) const {
  Eight eight(positions, normals);
  if (readsPlane_) {
    eight.layPlanes(normals, reach_);
    add<true>(eight, light);
    store(eight.planes(), positions.size(), means);
  } else {
    add<false>(eight, light);
    store(eight.mean(), positions.size(), means);
  }
  const int alone = _mm256_movemask_ps(_mm256_cmp_ps(eight.weight, all(0), _CMP_EQ_OQ));
  for (std::size_t lane = 0; alone && lane < positions.size(); ++lane)
    if (alone >> lane & 1) means[lane] = light[nearest(positions[lane])];
}

// The cluster nearest to x, whichever way it faces.
std::size_t ClusterSum::nearest(const glm::vec3& x) const {
  for (float reach = reach_;; reach *= 2) {
    std::size_t best = 0;
    float least = reach * reach;
    grid_.forEachRun(x, reach, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const glm::vec3 d = glm::vec3(x_[i], y_[i], z_[i]) - x;
        if (glm::dot(d, d) < least) least = glm::dot(d, d), best = i;
      }
    });
    if (least < reach * reach) return best;
  }
}

std::size_t ClusterSum::neighbours(std::size_t cluster) const {
  const glm::vec3 at(x_[cluster], y_[cluster], z_[cluster]);
  const Eight alone(std::span(&at, 1), std::span(&at, 1));
  std::size_t found = 0;
  grid_.forEachRun(at, reach_, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; i += kLanes)
      found += std::size_t(std::popcount(withinReach(alone, i, last)));
  });
  return found;
}

}  // namespace sonoskin
