#include "core/mesh/surface_patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::size_t kPatchesPerTask = 256;

// Gives all triangles around `seed` that are free, connected with it and near it to patch `number`.
void growPatch(const Facets& facets, std::uint32_t seed, std::uint32_t number, float radius,
               std::vector<std::uint32_t>& patch, std::vector<std::uint32_t>& queue) {
  queue.assign(1, seed);
  patch[seed] = number;
  for (std::size_t next = 0; next < queue.size(); ++next)
    for (std::uint32_t h = 3 * queue[next]; h < 3 * queue[next] + 3; ++h) {
      if (facets.opposite[h] == kNoHalfEdge) continue;
      const std::uint32_t t = facets.opposite[h] / 3;
      const glm::vec3 away = facets.centre[t] - facets.centre[seed];
      if (patch[t] != kNone || glm::dot(away, away) > radius * radius) continue;
      patch[t] = number;
      queue.push_back(t);
    }
}

void findCentres(const Facets& facets, SurfacePatches& patches, std::size_t count) {
  std::vector<glm::dvec4> sums(count, glm::dvec4(0));
  for (std::size_t t = 0; t < facets.size(); ++t) {
    const double weight =
        double(facets.area(t)) + 1e-12;  // patches of degenerate triangles have a centre, too
    sums[patches.ofTriangle[t]] += weight * glm::dvec4(glm::dvec3(facets.centre[t]), 1);
  }
  for (const glm::dvec4& s : sums) patches.centre.push_back(glm::vec3(glm::dvec3(s) / s.w));
}

void findNeighbours(const Facets& facets, SurfacePatches& patches) {
  const auto forEachBorder = [&](const auto& f) {
    for (std::uint32_t h = 0; h < facets.opposite.size(); ++h) {
      if (facets.opposite[h] == kNoHalfEdge) continue;
      const std::uint32_t a = patches.ofTriangle[h / 3], b = patches.ofTriangle[facets.opposite[h] / 3];
      if (a != b) f(a, b);
    }
  };
  std::vector<std::uint32_t> start(patches.size() + 2, 0);
  forEachBorder([&](std::uint32_t a, std::uint32_t) { ++start[a + 2]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> all(start.back());
  forEachBorder([&](std::uint32_t a, std::uint32_t b) { all[start[a + 1]++] = b; });
  patches.start.assign(1, 0);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto begin = all.begin() + start[p], end = all.begin() + start[p + 1];
    std::sort(begin, end);
    patches.neighbours.insert(patches.neighbours.end(), begin, std::unique(begin, end));
    patches.start.push_back(std::uint32_t(patches.neighbours.size()));
  }
}

// PatchSearch: the patches around one, found from patch to patch, and their squared distances. Keeps its memory between calls:
// to clear the stamps of all patches for some of them would cost more than the search.
struct PatchSearch {
  std::vector<std::uint32_t> found, stamp;
  std::vector<float> squared;
  std::uint32_t now = 0;

  void search(const SurfacePatches& patches, std::uint32_t from, float radius) {
    if (stamp.size() < patches.size()) stamp.resize(patches.size(), 0);
    if (++now == 0) std::fill(stamp.begin(), stamp.end(), 0), now = 1;
    found.assign(1, from);
    squared.assign(1, 0);
    stamp[from] = now;
    const glm::vec3 centre = patches.centre[from];
    for (std::size_t next = 0; next < found.size(); ++next) {
      const std::uint32_t begin = patches.start[found[next]], end = patches.start[found[next] + 1];
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t p = patches.neighbours[i];
        if (stamp[p] == now) continue;
        stamp[p] = now;
        const glm::vec3 away = patches.centre[p] - centre;
        if (glm::dot(away, away) > radius * radius) continue;
        found.push_back(p);
        squared.push_back(glm::dot(away, away));
      }
    }
  }
};

}  // namespace

SurfacePatches growPatches(const Facets& facets, float radius, const Progress& progress) {
  SurfacePatches patches;
  patches.radius = radius;
  patches.ofTriangle.assign(facets.size(), kNone);
  std::vector<std::uint32_t> queue;
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < facets.size(); ++t) {
    if (t % 65536 == 0) progress.update(0.5 * double(t) / double(facets.size()));
    if (patches.ofTriangle[t] == kNone) growPatch(facets, t, count++, radius, patches.ofTriangle, queue);
  }
  findCentres(facets, patches, count);
  progress.update(0.7);
  findNeighbours(facets, patches);
  return patches;
}

std::vector<glm::vec4> smoothOverPatches(const SurfacePatches& patches, const std::vector<glm::vec4>& sums,
                                         float sigma, const Progress& progress) {
  const float falloff = -0.5f / (sigma * sigma), reach = 2.5f * sigma;
  std::vector<glm::vec4> smooth(patches.size());
  parallelItems(
      patches.size(), kPatchesPerTask,
      [&](std::size_t p) {
        thread_local PatchSearch around;
        around.search(patches, std::uint32_t(p), reach);
        glm::vec4 sum(0);
        for (std::size_t i = 0; i < around.found.size(); ++i)
          sum += std::exp(falloff * around.squared[i]) * sums[around.found[i]];
        smooth[p] = sum;
      },
      progress);
  return smooth;
}

glm::vec4 atPoint(const SurfacePatches& patches, const std::vector<glm::vec4>& values, std::uint32_t home,
                  const glm::vec3& point) {
  const float reach2 = 6.25f * patches.radius * patches.radius;
  // The own patch always counts a little: a large triangle's corners may be far from every centre.
  float weights = 1e-6f;
  glm::vec4 sum = weights * values[home];
  const auto add = [&](std::uint32_t p) {
    const glm::vec3 away = patches.centre[p] - point;
    const float near = std::max(0.f, 1 - glm::dot(away, away) / reach2), weight = near * near;
    sum += weight * values[p];
    weights += weight;
  };
  add(home);
  for (std::uint32_t i = patches.start[home]; i < patches.start[home + 1]; ++i) add(patches.neighbours[i]);
  return sum / weights;
}

}  // namespace sonoskin
