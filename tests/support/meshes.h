#pragma once

#include <cmath>
#include <map>

#include "core/mesh/mesh.h"

namespace sonoskin::test {

// icosphere: a closed sphere of 20 * 4^level triangles, counter-clockwise from outside, normals outward.
inline Mesh icosphere(int level, float radius, const glm::vec3& centre) {
  const float g = 0.5f * (1 + std::sqrt(5.f));
  std::vector<glm::vec3> points{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Triangle> triangles{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (; level > 0; --level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, isNew] = middles.try_emplace(std::minmax(a, b), std::uint32_t(points.size()));
      if (isNew) points.push_back(glm::normalize(points[a]) + glm::normalize(points[b]));
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles = finer;
  }
  Mesh mesh;
  mesh.triangles = triangles;
  for (const glm::vec3& p : points) {
    mesh.normals.push_back(glm::normalize(p));
    mesh.positions.push_back(centre + radius * mesh.normals.back());
  }
  return mesh;
}

}  // namespace sonoskin::test
