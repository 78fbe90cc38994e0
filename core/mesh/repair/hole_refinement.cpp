#include "core/mesh/repair/hole_refinement.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/half_edges.h"

namespace sonoskin {
namespace {

using IsAllowed = std::function<bool(std::uint32_t, std::uint32_t)>;

constexpr double kManyPoints = 1500;

// Swapper: swaps the sides of a patch's triangles.
class Swapper {
 public:
  Swapper(HolePatch& patch, const IsAllowed& isAllowed, std::size_t loop)
      : patch_(patch),
        isAllowed_(isAllowed),
        loop_(loop),
        opposite_(oppositeHalfEdges(patch.triangles, patch.points.size())) {}

  // swapAll: one look at every side; how many were swapped.
  std::size_t swapAll() {
    std::size_t swapped = 0;
    for (std::uint32_t h = 0; h < opposite_.size(); ++h)
      if (opposite_[h] != kNoHalfEdge && h < opposite_[h] && shouldSwap(h)) {
        swap(h);
        ++swapped;
      }
    return swapped;
  }

 private:
  static std::uint32_t previous(std::uint32_t h) { return nextHalfEdge(nextHalfEdge(h)); }
  std::uint32_t origin(std::uint32_t h) const { return originOf(patch_.triangles, h); }
  const glm::dvec3& point(std::uint32_t h) const { return patch_.points[origin(h)]; }

  // The cotangent of the angle across a side.
  double cotangent(std::uint32_t h) const {
    const glm::dvec3 &a = point(h), &b = point(nextHalfEdge(h)), &c = point(previous(h));
    const double sine = glm::length(glm::cross(a - c, b - c));
    return sine > 0 ? glm::dot(a - c, b - c) / sine : 1e9;
  }

  bool areJoined(std::uint32_t corner, std::uint32_t other) const {
    std::uint32_t h = corner;  // around the vertex, both ways up to the border
    do {
      if (origin(nextHalfEdge(h)) == other || origin(previous(h)) == other) return true;
      h = opposite_[previous(h)];
    } while (h != kNoHalfEdge && h != corner);
    if (h == corner) return false;
    for (h = opposite_[corner]; h != kNoHalfEdge; h = opposite_[nextHalfEdge(h)])
      if (origin(h) == other || origin(previous(h)) == other) return true;
    return false;
  }

  // The two angles across the side add up to more than a half turn, and the swap folds nothing over.
  bool shouldSwap(std::uint32_t h) const {
    const std::uint32_t g = opposite_[h];
    if (cotangent(h) + cotangent(g) > -1e-6) return false;
    const std::uint32_t c = origin(previous(h)), d = origin(previous(g));
    if (c < loop_ && d < loop_ && !isAllowed_(c, d)) return false;
    if (areJoined(previous(h), d)) return false;
    const glm::dvec3 &pa = point(h), &pb = point(g), &pc = patch_.points[c], &pd = patch_.points[d];
    const glm::dvec3 before = glm::cross(pb - pa, pc - pa) + glm::cross(pa - pb, pd - pb);
    return glm::dot(glm::cross(pd - pa, pc - pa), before) > 0 &&
           glm::dot(glm::cross(pb - pd, pc - pd), before) > 0;
  }

  void link(std::uint32_t h, std::uint32_t other) {
    opposite_[h] = other;
    if (other != kNoHalfEdge) opposite_[other] = h;
  }

  void swap(std::uint32_t h) {
    const std::uint32_t g = opposite_[h], t = h / 3, u = g / 3;
    const std::uint32_t a = origin(h), b = origin(g), c = origin(previous(h)), d = origin(previous(g));
    const std::uint32_t ad = opposite_[nextHalfEdge(g)], ca = opposite_[previous(h)],
                        db = opposite_[previous(g)], bc = opposite_[nextHalfEdge(h)];
    patch_.triangles[t] = {a, d, c};
    patch_.triangles[u] = {d, b, c};
    link(3 * t, ad);
    link(3 * t + 1, 3 * u + 2);
    link(3 * t + 2, ca);
    link(3 * u, db);
    link(3 * u + 1, bc);
  }

  HolePatch& patch_;
  const IsAllowed& isAllowed_;
  std::size_t loop_;
  std::vector<std::uint32_t> opposite_;
};

// Splits every triangle that is large beside the sizes wanted around it; how many there were.
std::size_t splitLarge(HolePatch& patch, std::vector<double>& sizes, double growth) {
  const std::size_t before = patch.triangles.size();
  for (std::size_t t = 0; t < before; ++t) {
    const auto [a, b, c] = patch.triangles[t];
    const glm::dvec3 middle = (patch.points[a] + patch.points[b] + patch.points[c]) / 3.0;
    const double size = growth * (sizes[a] + sizes[b] + sizes[c]) / 3;
    const auto isFar = [&](std::uint32_t v) {
      return std::sqrt(2.0) * glm::distance(middle, patch.points[v]) > std::max(size, sizes[v]);
    };
    if (!isFar(a) || !isFar(b) || !isFar(c)) continue;
    const auto m = std::uint32_t(patch.points.size());
    patch.points.push_back(middle);
    sizes.push_back(size);
    patch.triangles[t] = {a, b, m};
    patch.triangles.push_back({b, c, m});
    patch.triangles.push_back({c, a, m});
  }
  return patch.triangles.size() - before;
}

// How much the size wanted grows with each generation of points, so that there are not too many.
double growthFor(const HolePatch& patch, const std::vector<double>& sizes) {
  double area = 0, size = 0;
  for (const auto& [a, b, c] : patch.triangles)
    area +=
        0.5 * glm::length(glm::cross(patch.points[b] - patch.points[a], patch.points[c] - patch.points[a]));
  for (const double s : sizes) size += s / double(sizes.size());
  const double points = area / (0.87 * size * size);
  return points > kManyPoints ? std::pow(points / kManyPoints, 0.1) : 1;
}

}  // namespace

void refinePatch(HolePatch& patch, std::vector<double> sizes, const IsAllowed& isAllowed,
                 const Progress& progress) {
  constexpr int kRounds = 30, kSwaps = 20;
  const std::size_t loop = patch.points.size();
  const double growth = growthFor(patch, sizes);
  for (int round = 0; round < kRounds; ++round) {
    Swapper swapper(patch, isAllowed, loop);
    for (int i = 0; i < kSwaps && swapper.swapAll() > 0; ++i) progress.throwIfCancelled();
    if (splitLarge(patch, sizes, growth) == 0) break;
    progress.update(double(round) / kRounds);
  }
}

}  // namespace sonoskin
