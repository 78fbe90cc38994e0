#include "core/mesh/repair/hole_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace sonoskin {
namespace {

using IsAllowed = std::function<bool(std::uint32_t, std::uint32_t)>;

constexpr std::size_t kLongest = 128;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Less is better: first the sharpest fold, then the area.
struct Weight {
  double fold = 0;  // 1 - cosine of the largest angle between neighbours
  double area = 0;
  bool operator<(const Weight& o) const { return fold != o.fold ? fold < o.fold : area < o.area; }
  static Weight impossible() { return {kInfinity, kInfinity}; }
};

// The best triangulation of one polygon of a few points: best_[i][j] is that of the points i to j, closed by the
// chord (i, j), whose triangle has its third corner at apex_[i][j].
class Polygon {
 public:
  // normals: zero beyond a side where nothing is known
  Polygon(std::vector<glm::dvec3> points, std::vector<glm::dvec3> normals)
      : points_(std::move(points)),
        normals_(std::move(normals)),
        best_(points_.size() * points_.size()),
        apex_(points_.size() * points_.size(), 0) {}

  // Allowed: whether points i and j may be joined.
  template <class Allowed>
  bool solve(const Allowed& allowed) {
    const std::size_t n = points_.size();
    for (std::size_t span = 2; span < n; ++span)
      for (std::size_t i = 0; i + span < n; ++i) {
        const std::size_t j = i + span;
        const bool isSide = i == 0 && j + 1 == n;
        best_[at(i, j)] = Weight::impossible();
        if (isSide || allowed(i, j)) choose(i, j, isSide);
      }
    return best_[at(0, n - 1)].fold < kInfinity;
  }

  template <class F>
  void forEachTriangle(const F& f) const {
    std::vector<std::array<std::size_t, 2>> pending{{0, points_.size() - 1}};
    while (!pending.empty()) {
      const auto [i, j] = pending.back();
      pending.pop_back();
      if (j - i < 2) continue;
      const std::size_t m = apex_[at(i, j)];
      f(i, m, j);
      pending.push_back({i, m});
      pending.push_back({m, j});
    }
  }

 private:
  std::size_t at(std::size_t i, std::size_t j) const { return i * points_.size() + j; }

  glm::dvec3 areaNormal(std::size_t i, std::size_t m, std::size_t j) const {
    return glm::cross(points_[m] - points_[i], points_[j] - points_[i]);
  }

  // The unit normal beyond the chord or side (i, j), as seen from the triangle on its other flank.
  glm::dvec3 beyond(std::size_t i, std::size_t j) const {
    if (j == i + 1) return normals_[i];
    const glm::dvec3 n = areaNormal(i, apex_[at(i, j)], j);
    const double length = glm::length(n);
    return length > 0 ? n / length : glm::dvec3(0);
  }

  static double fold(const glm::dvec3& unit, const glm::dvec3& other) {
    return other == glm::dvec3(0) ? 0 : 1 - glm::dot(unit, other);
  }

  void choose(std::size_t i, std::size_t j, bool isSide) {
    for (std::size_t m = i + 1; m < j; ++m) {
      const Weight &left = best_[at(i, m)], &right = best_[at(m, j)];
      if (left.fold == kInfinity || right.fold == kInfinity) continue;
      const glm::dvec3 normal = areaNormal(i, m, j);
      const double twice = glm::length(normal);
      const glm::dvec3 unit = twice > 0 ? normal / twice : glm::dvec3(0);
      Weight w{std::max({left.fold, right.fold, fold(unit, beyond(i, m)), fold(unit, beyond(m, j))}),
               left.area + right.area + 0.5 * twice};
      if (isSide) w.fold = std::max(w.fold, fold(unit, normals_[j]));
      if (w < best_[at(i, j)]) {
        best_[at(i, j)] = w;
        apex_[at(i, j)] = std::uint32_t(m);
      }
    }
  }

  std::vector<glm::dvec3> points_, normals_;
  std::vector<Weight> best_;
  std::vector<std::uint32_t> apex_;
};

// Part: some of the loop's points in order, and the normals beyond the sides between them.
struct Part {
  std::vector<std::uint32_t> indices;
  std::vector<glm::dvec3> normals;
};

// Whether a direction from point i of a part leads into the hole: between the side after it and the one before,
// counter-clockwise around the normal.
bool leadsInside(const HoleLoop& loop, const Part& part, std::size_t i, const glm::dvec3& direction) {
  const std::size_t n = part.indices.size(), all = loop.points.size();
  const std::uint32_t v = part.indices[i];
  const glm::dvec3 normal = loop.normals[v] + loop.normals[(v + all - 1) % all];
  const glm::dvec3 after = loop.points[part.indices[(i + 1) % n]] - loop.points[v];
  const glm::dvec3 before = loop.points[part.indices[(i + n - 1) % n]] - loop.points[v];
  const auto angle = [&](const glm::dvec3& d) {
    const double a =
        std::atan2(glm::dot(glm::cross(after, d), normal), glm::dot(after, d) * glm::length(normal));
    return a < 0 ? a + 2 * std::numbers::pi : a;
  };
  return angle(direction) < angle(before);
}

// The chord through the hole that is shortest beside the way around it, neither end of which is near the other along
// the loop. `inside`: both ends must lead into the hole.
std::array<std::size_t, 2> shortestChord(const HoleLoop& loop, const Part& part, const IsAllowed& isAllowed,
                                         bool inside) {
  const std::size_t n = part.indices.size(), least = n / 6;
  double best = kInfinity;
  std::array<std::size_t, 2> chord{0, 0};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + least; j < n && j - i <= n - least; ++j) {
      const glm::dvec3 d = loop.points[part.indices[j]] - loop.points[part.indices[i]];
      const double ratio = glm::length(d) / double(std::min(j - i, n - (j - i)));
      if (ratio >= best || !isAllowed(part.indices[i], part.indices[j])) continue;
      if (inside && !(leadsInside(loop, part, i, d) && leadsInside(loop, part, j, -d))) continue;
      best = ratio;
      chord = {i, j};
    }
  return chord;
}

Part cutOut(const Part& part, std::size_t first, std::size_t last) {
  Part piece;
  for (std::size_t i = first;; i = (i + 1) % part.indices.size()) {
    piece.indices.push_back(part.indices[i]);
    if (i == last) break;
    piece.normals.push_back(part.normals[i]);
  }
  piece.normals.push_back(glm::dvec3(0));  // the chord's
  return piece;
}

}  // namespace

std::vector<Triangle> triangulateLoop(const HoleLoop& loop, const IsAllowed& isAllowed) {
  std::vector<Triangle> triangles;
  std::vector<Part> parts(1);
  parts[0].indices.resize(loop.points.size());
  std::iota(parts[0].indices.begin(), parts[0].indices.end(), 0u);
  parts[0].normals = loop.normals;
  while (!parts.empty()) {
    const Part part = std::move(parts.back());
    parts.pop_back();
    if (part.indices.size() > kLongest) {
      std::array<std::size_t, 2> chord = shortestChord(loop, part, isAllowed, true);
      if (chord[0] == chord[1]) chord = shortestChord(loop, part, isAllowed, false);
      if (chord[0] == chord[1]) return {};
      parts.push_back(cutOut(part, chord[0], chord[1]));
      parts.push_back(cutOut(part, chord[1], chord[0]));
      continue;
    }
    std::vector<glm::dvec3> points;
    for (const std::uint32_t i : part.indices) points.push_back(loop.points[i]);
    Polygon polygon(std::move(points), part.normals);
    const auto allowed = [&](std::size_t i, std::size_t j) {
      return isAllowed(part.indices[i], part.indices[j]);
    };
    if (!polygon.solve(allowed)) return {};
    polygon.forEachTriangle([&](std::size_t i, std::size_t m, std::size_t j) {
      triangles.push_back({part.indices[i], part.indices[m], part.indices[j]});
    });
  }
  return triangles;
}

}  // namespace sonoskin
