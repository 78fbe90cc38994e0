#include "core/mesh/print/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sonoskin {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kReach = 2;

// A value per column.
struct Columns {
  glm::ivec2 dims;
  std::vector<float> values;

  explicit Columns(const glm::ivec2& d, float value)
      : dims(d), values(std::size_t(d.x) * std::size_t(d.y), value) {}
  float& at(int i, int j) { return values[std::size_t(j) * std::size_t(dims.x) + std::size_t(i)]; }
  float at(int i, int j) const { return values[std::size_t(j) * std::size_t(dims.x) + std::size_t(i)]; }
  bool has(int i, int j) const { return i >= 0 && j >= 0 && i < dims.x && j < dims.y; }
};

// Draws one triangle, given in cells, into the columns that pass through it; the nearest place is kept.
void draw(Columns& first, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec2 u(b - a), v(c - a);
  const double area = u.x * v.y - u.y * v.x;
  if (area == 0) return;
  const glm::dvec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
  for (int j = int(std::ceil(low.y)); j <= int(std::floor(high.y)); ++j)
    for (int i = int(std::ceil(low.x)); i <= int(std::floor(high.x)); ++i) {
      const glm::dvec2 d = glm::dvec2(i, j) - glm::dvec2(a);
      const double s = (d.x * v.y - d.y * v.x) / area, t = (u.x * d.y - u.y * d.x) / area;
      constexpr double kSlack = 1e-9;  // none falls between two triangles
      if (s < -kSlack || t < -kSlack || s + t > 1 + kSlack || !first.has(i, j)) continue;
      float& z = first.at(i, j);
      z = std::min(z, float(a.z + s * (b.z - a.z) + t * (c.z - a.z)));
    }
}

// Along both axes, one after the other: reduce(values of the window's columns) -> new value.
template <class Reduce>
Columns windowed(const Columns& columns, const Reduce& reduce) {
  Columns now = columns;
  for (const glm::ivec2 axis : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
    Columns next = now;
    for (int j = 0; j < now.dims.y; ++j)
      for (int i = 0; i < now.dims.x; ++i) {
        std::array<float, 2 * kReach + 1> window;
        for (int o = -kReach; o <= kReach; ++o) {
          const glm::ivec2 at = glm::clamp(glm::ivec2(i, j) + o * axis, glm::ivec2(0), now.dims - 1);
          window[std::size_t(o + kReach)] = now.at(at.x, at.y);
        }
        next.at(i, j) = reduce(window);
      }
    now = std::move(next);
  }
  return now;
}

using Window = std::array<float, 2 * kReach + 1>;

// The deepest; columns without a surface have no say, so that every use widens the surface's outline too.
float deepest(const Window& w) {
  float most = -kInfinity;
  for (const float z : w)
    if (z < kInfinity) most = std::max(most, z);
  return most > -kInfinity ? most : kInfinity;
}

float blurred(const Window& w) {
  constexpr Window kBinomial{1, 4, 6, 4, 1};
  float sum = 0, weights = 0;
  for (std::size_t i = 0; i < w.size(); ++i)
    if (w[i] < kInfinity) {
      sum += kBinomial[i] * w[i];
      weights += kBinomial[i];
    }
  return weights > 0 ? sum / weights : kInfinity;
}

}  // namespace

Relief makeRelief(const Mesh& surface, const Geometry& grid, float depth, const Progress& progress) {
  const glm::ivec2 dims(grid.dims);
  const auto cell = float(grid.spacing.x);
  Columns first(dims, kInfinity), covered(dims, 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (t % 65536 == 0) progress.update(0.6 * double(t) / double(surface.triangles.size()));
    const auto& [a, b, c] = surface.triangles[t];
    draw(first, grid.toIndex(glm::dvec3(surface.positions[a])),
         grid.toIndex(glm::dvec3(surface.positions[b])), grid.toIndex(glm::dvec3(surface.positions[c])));
  }
  for (std::size_t c = 0; c < first.values.size(); ++c) covered.values[c] = first.values[c] < kInfinity;
  progress.update(0.6);
  const Columns start = windowed(windowed(first, deepest), blurred), share = windowed(covered, blurred);
  progress.update(0.9);

  Relief relief{dims, cell, {}, {}, {}};
  for (int j = 0; j < dims.y; ++j)
    for (int i = 0; i < dims.x; ++i) {
      const auto z = [&](int di, int dj) {
        const glm::ivec2 at = glm::clamp(glm::ivec2(i + di, j + dj), glm::ivec2(0), dims - 1);
        const float value = start.at(at.x, at.y);
        return value < kInfinity ? value : start.at(i, j);
      };
      const glm::vec2 gradient = 0.5f * glm::vec2(z(1, 0) - z(-1, 0), z(0, 1) - z(0, -1));
      relief.start.push_back(start.at(i, j) * cell + depth);
      relief.slope.push_back(start.at(i, j) < kInfinity ? 1 / std::sqrt(1 + glm::dot(gradient, gradient))
                                                        : 1.f);
      // Across a straight outline the blurred share falls by 3/8 per column.
      relief.beyond.push_back((0.5f - share.at(i, j)) * cell * 8 / 3);
    }
  progress.update(1);
  return relief;
}

}  // namespace sonoskin
