#include "core/skin/shown_places.h"

#include "core/base/parallel_blocks.h"
#include "core/mesh/closest_point.h"

namespace sonoskin {
namespace {

constexpr std::size_t kPerTask = 16384;

bool isShown(const AtlasMaps& maps, int x, int y) {
  const auto coverage = [&](int u, int v) {
    if (u < 0 || v < 0 || u >= maps.size.x || v >= maps.size.y) return 0.f;
    return maps.position[std::size_t(v) * std::size_t(maps.size.x) + std::size_t(u)].w;
  };
  const float own = coverage(x, y);
  if (own == 0 || own == 1) return own == 1;
  for (int k = 0; k < 9; ++k)
    if (coverage(x + k % 3 - 1, y + k / 3 - 1) == 1) return true;
  return false;
}

template <class Test>
std::vector<std::uint32_t> texelsWith(const AtlasMaps& maps, const Test& test) {
  std::vector<std::vector<std::uint32_t>> rows(std::size_t(maps.size.y));
  parallelItems(rows.size(), 16, [&](std::size_t y) {
    for (int x = 0; x < maps.size.x; ++x)
      if (test(x, int(y)))
        rows[y].push_back(std::uint32_t(y) * std::uint32_t(maps.size.x) + std::uint32_t(x));
  });
  std::vector<std::uint32_t> texels;
  for (const std::vector<std::uint32_t>& row : rows) texels.insert(texels.end(), row.begin(), row.end());
  return texels;
}

}  // namespace

std::vector<std::uint32_t> shownTexels(const AtlasMaps& maps) {
  return texelsWith(maps, [&](int x, int y) { return isShown(maps, x, y); });
}

std::vector<std::uint32_t> coveredTexels(const AtlasMaps& maps) {
  return texelsWith(maps, [&](int x, int y) {
    return maps.position[std::size_t(y) * std::size_t(maps.size.x) + std::size_t(x)].w > 0;
  });
}

SurfacePlace placeOfTexel(const SkinSurface& surface, std::uint32_t texel) {
  const std::uint32_t t = surface.maps.triangle[texel];
  const std::vector<glm::vec3>& vertices = surface.mesh->positions;
  const auto& [i, j, k] = surface.mesh->triangles[t];
  const glm::vec3 at(surface.maps.position[texel]);
  return {t, closestPointOnTriangle(at, vertices[i], vertices[j], vertices[k]).weights};
}

DiffusionPlaces inLocalOrder(const Mesh& mesh, const std::vector<SurfacePlace>& places) {
  std::vector<glm::vec3> positions(places.size()), normals(places.size());
  parallelItems(places.size(), kPerTask, [&](std::size_t p) {
    const auto& [triangle, w] = places[p];
    const auto& [i, j, k] = mesh.triangles[triangle];
    const auto mix = [&](const std::vector<glm::vec3>& of) {
      return w.x * of[i] + w.y * of[j] + w.z * of[k];
    };
    positions[p] = mix(mesh.positions);
    const glm::vec3 normal = mix(mesh.normals);
    const float length = glm::length(normal);
    normals[p] = length > 0 ? normal / length : mesh.normals[i];
  });
  return inLocalOrder(positions, normals);
}

}  // namespace sonoskin
