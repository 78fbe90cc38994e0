#include "tests/benchmarks/accuracy/skin_places.h"

#include <cmath>
#include <random>

#include "core/mesh/half_edges.h"
#include "core/mesh/search/point_grid.h"

namespace sonoskin::accuracy {

SkinPlaces spreadPlaces(const Mesh& mesh, std::size_t count) {
  std::vector<double> below{0};  // area of all triangles before
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    below.push_back(below.back() + 0.5 * glm::length(glm::cross(b - a, c - a)));
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  SkinPlaces result;
  for (std::size_t i = 0; i < count; ++i) {
    const double area = below.back() * (double(i) + uniform(random)) / double(count);
    const auto after = std::upper_bound(below.begin(), below.end() - 1, area);
    const auto triangle = std::size_t(after - below.begin()) - 1;
    const double root = std::sqrt(uniform(random)), part = uniform(random);
    const glm::vec3 w(1 - root, root * (1 - part), root * part);
    const Triangle& t = mesh.triangles[triangle];
    const auto mix = [&](const std::vector<glm::vec3>& of) {
      return w.x * of[t[0]] + w.y * of[t[1]] + w.z * of[t[2]];
    };
    result.places.push_back({std::uint32_t(triangle), w});
    result.positions.push_back(mix(mesh.positions));
    result.normals.push_back(glm::normalize(mix(mesh.normals)));
  }
  return result;
}

std::size_t placesFor(const Mesh& mesh) { return std::size_t(std::ceil(4 * surfaceArea(mesh))); }

std::vector<DiffusionTarget> targetsOf(const SkinPlaces& places, const SkinLighting& lighting) {
  std::vector<DiffusionTarget> targets;
  for (std::size_t i = 0; i < places.positions.size(); ++i) {
    const glm::vec3 &p = places.positions[i], &n = places.normals[i];
    targets.push_back({p, n, glm::vec3(lighting(p, n))});
  }
  return targets;
}

Seams findSeams(const Mesh& mesh, const Atlas& atlas) {
  constexpr float kStep = 0.5f;  // mm
  Seams seams;
  const std::vector<std::uint32_t> opposite = oppositeHalfEdges(mesh.triangles, mesh.positions.size());
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    const std::uint32_t o = opposite[h];
    if (o == kNoHalfEdge || o < h || atlas.chart[h / 3] == atlas.chart[o / 3]) continue;
    const glm::vec3 &a = mesh.positions[originOf(mesh.triangles, h)],
                    &b = mesh.positions[originOf(mesh.triangles, nextHalfEdge(h))];
    const int steps = std::max(1, int(glm::distance(a, b) / kStep));
    for (int i = 0; i < steps; ++i) {
      const float along = (float(i) + 0.5f) / float(steps);
      SkinPlace here{h / 3, glm::vec3(0)}, there{o / 3, glm::vec3(0)};
      here.weights[int(h % 3)] = there.weights[int(nextHalfEdge(o) % 3)] = 1 - along;
      here.weights[int(nextHalfEdge(h) % 3)] = there.weights[int(o % 3)] = along;
      seams.sides.push_back({here, there});
      seams.positions.push_back(glm::mix(a, b, along));
    }
  }
  return seams;
}

std::vector<bool> nearSeams(const std::vector<glm::vec3>& positions, const Seams& seams, float distance) {
  std::vector<bool> near(positions.size(), false);
  if (seams.positions.empty()) return near;
  const PointGrid grid(seams.positions, distance);
  for (std::size_t i = 0; i < positions.size(); ++i)
    grid.forEachRun(positions[i], distance, [&](std::size_t first, std::size_t last) {
      for (std::size_t s = first; s < last; ++s)
        if (glm::distance(seams.positions[grid.order()[s]], positions[i]) < distance) near[i] = true;
    });
  return near;
}

}  // namespace sonoskin::accuracy
