#include "core/face/face_search.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <unordered_map>

#include "core/base/parallel.h"
#include "core/base/perpendicular.h"
#include "core/face/face_score.h"

namespace sonoskin {
namespace {

using glm::vec3;

constexpr std::size_t kRoughPoints = 96, kFairPoints = 200, kAllPoints = 100000;
constexpr float kRoughWidth = 4, kFairWidth = 2.5f, kFineWidth = 1.5f;
constexpr int kRolls = 20;
constexpr std::size_t kRough = 1200, kFair = 36, kFine = 8;
const vec3 kAnchor(0, -12, 37);  // of the mean face, between the nose's wings: it lies on the surface

// Seed: a place of the surface where a search begins, and where it looks.
struct Seed {
  vec3 place, normal;
};

// Places some mm apart, with normals of what lies within twice that.
std::vector<Seed> findSeeds(const FaceSpace& space, const vec3& toProbe, float apart) {
  struct Sum {
    vec3 place{0}, normal{0};
    float count = 0;
  };
  std::unordered_map<std::uint64_t, Sum> sums;
  const auto keyOf = [](const glm::ivec3& c) {
    return (std::uint64_t(std::uint32_t(c.z) & 0x1fffff) << 42) |
           (std::uint64_t(std::uint32_t(c.y) & 0x1fffff) << 21) | (std::uint32_t(c.x) & 0x1fffff);
  };
  const auto cellOf = [&](const vec3& p) { return glm::ivec3(glm::floor(p / apart)); };
  for (const Surfel& surfel : space.surfels()) {
    Sum& sum = sums[keyOf(cellOf(surfel.place))];
    sum.place += surfel.place;
    sum.normal += surfel.normal;
    ++sum.count;
  }
  std::vector<Seed> seeds;
  for (const auto& [key, sum] : sums) {
    if (sum.count < 6) continue;
    const vec3 place = sum.place / sum.count;
    const glm::ivec3 cell = cellOf(place);
    vec3 normal(0);
    for (int n = 0; n < 27; ++n) {
      const auto around = sums.find(keyOf(cell + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1));
      if (around != sums.end()) normal += around->second.normal;
    }
    if (glm::length(normal) < 6 || glm::dot(glm::normalize(normal), toProbe) < 0.1f) continue;
    seeds.push_back({place, glm::normalize(normal)});
  }
  std::sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) {
    return std::array{a.place.x, a.place.y, a.place.z} < std::array{b.place.x, b.place.y, b.place.z};
  });
  return seeds;
}

FacePlacement placedAt(const Seed& seed, const glm::quat& bend, float roll, float scale) {
  const vec3 left = glm::normalize(glm::cross(axisAside<0, 1>(seed.normal, 0.7), seed.normal));
  FacePlacement face;
  const glm::mat3 upright(left, glm::cross(seed.normal, left), seed.normal);
  face.turn = upright * glm::mat3_cast(glm::angleAxis(roll, vec3(0, 0, 1)) * bend);
  face.scale = scale;
  face.at = seed.place - scale * (face.turn * kAnchor);
  return face;
}

// The best of all rolls, bends and sizes at one place.
std::vector<FaceHypothesis> tryPlace(const Seed& seed, const FaceSpace& space, const vec3& toProbe,
                                     const SizePrior& size) {
  constexpr float kBend = 0.44f;
  const glm::quat bends[] = {glm::quat(1, 0, 0, 0), glm::angleAxis(kBend, vec3(1, 0, 0)),
                             glm::angleAxis(-kBend, vec3(1, 0, 0)), glm::angleAxis(kBend, vec3(0, 1, 0)),
                             glm::angleAxis(-kBend, vec3(0, 1, 0))};
  std::vector<FaceHypothesis> best;
  for (int roll = 0; roll < kRolls; ++roll) {
    FaceHypothesis top{{}, -1};
    for (const glm::quat& bend : bends)
      for (const float step : {-1.2f, 0.f, 1.2f}) {
        const float scale = size.middle * std::exp(step * size.spread);
        const FacePlacement face = placedAt(seed, bend, float(roll) * 6.2831853f / kRolls, scale);
        if (glm::dot(face.front(), toProbe) < 0.25f) continue;
        const float score = faceScore(face, space, kRoughPoints, kRoughWidth);
        if (score > top.score) top = {face, score};
      }
    if (top.score > 0) best.push_back(top);
  }
  return best;
}

void keepBest(std::vector<FaceHypothesis>& all, std::size_t count) {
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.score > b.score; });
  if (all.size() > count) all.resize(count);
}

// Whether two faces are the same: by the place between the wings of the nose, in mm, and by cosines of up and front.
bool alike(const FacePlacement& a, const FacePlacement& b, float apart, float cosine) {
  return glm::distance(a.toWorld(kAnchor), b.toWorld(kAnchor)) < apart * a.scale &&
         glm::dot(a.up(), b.up()) > cosine && glm::dot(a.front(), b.front()) > cosine;
}

// Of `all`, best first, those that are like none before them.
void keepUnlike(std::vector<FaceHypothesis>& all, std::size_t count, float apart, float cosine) {
  std::vector<FaceHypothesis> kept;
  for (const FaceHypothesis& h : all) {
    if (kept.size() == count) break;
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const auto& k) { return alike(k.face, h.face, apart, cosine); }))
      kept.push_back(h);
  }
  all = std::move(kept);
}

void weigh(std::vector<FaceHypothesis>& all, const FaceSpace& space, const vec3& toProbe) {
  for (FaceHypothesis& h : all) {
    h.evidence = faceEvidence(h.face, space);
    const float facing = 0.6f + 0.4f * glm::dot(h.face.front(), toProbe);
    const float relief = std::max(h.evidence.relief, 0.f);
    h.worth = h.score * facing * relief * relief;
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.worth > b.worth; });
}

void refineAll(std::vector<FaceHypothesis>& all, const FaceSpace& space, const SizePrior& size,
               const RefineSteps& steps, float width, const Progress& progress) {
  parallelFor(
      std::ptrdiff_t(all.size()),
      [&](std::ptrdiff_t n) {
        FaceHypothesis& h = all[std::size_t(n)];
        h.face = refineFace(h.face, space, size, steps);
        const float off = std::log(h.face.scale / size.middle) / size.spread;
        h.score = faceScore(h.face, space, steps.points, width) - 0.02f * off * off;
      },
      progress);
}

}  // namespace

std::vector<FaceHypothesis> searchFaces(const FaceSpace& space, const vec3& toProbe, const SizePrior& size,
                                        const Progress& progress) {
  const std::vector<Seed> seeds = findSeeds(space, toProbe, 8 * size.middle);
  std::vector<std::vector<FaceHypothesis>> tried(seeds.size());
  parallelFor(
      std::ptrdiff_t(seeds.size()),
      [&](std::ptrdiff_t n) {
        tried[std::size_t(n)] = tryPlace(seeds[std::size_t(n)], space, toProbe, size);
      },
      progress.part(0, 0.4));
  std::vector<FaceHypothesis> all;
  for (const auto& some : tried) all.insert(all.end(), some.begin(), some.end());
  keepBest(all, kRough);
  refineAll(all, space, size, {6, kFairPoints, 8, 4, false}, kFairWidth, progress.part(0.4, 0.7));
  keepBest(all, all.size());
  keepUnlike(all, kFair, 4, 0.95f);
  refineAll(all, space, size, {12, kAllPoints, 6, 3, true}, kFineWidth, progress.part(0.7, 1));
  weigh(all, space, toProbe);
  keepUnlike(all, kFine, 6, 0.9f);
  return all;
}

}  // namespace sonoskin
