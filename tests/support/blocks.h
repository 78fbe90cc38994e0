#pragma once

#include <cmath>
#include <memory>

#include "core/skin/skin_surface.h"

namespace sonoskin::test {

// surfaceInBlocks: a mesh whose triangles lie in squares of `side` texels of their own, one each, with the maps of places
// and normals; the texels of a square that the triangle leaves are its rim.
inline std::shared_ptr<const SkinSurface> surfaceInBlocks(const Mesh& mesh, int side) {
  auto surface = std::make_shared<SkinSurface>();
  const int perRow = int(std::ceil(std::sqrt(double(mesh.triangles.size()))));
  surface->mesh = std::make_shared<Mesh>(mesh);
  surface->pointBased = true;
  surface->atlas.size = surface->maps.size = glm::ivec2(perRow * side);
  const auto texels = std::size_t(perRow * side) * std::size_t(perRow * side);
  surface->maps.position.assign(texels, glm::vec4(0));
  surface->maps.normal.assign(texels, glm::vec4(0));
  surface->maps.triangle.assign(texels, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::ivec2 low = side * glm::ivec2(int(t) % perRow, int(t) / perRow);
    const glm::vec2 first = glm::vec2(low) + 0.5f;
    const float length = float(side) - 1;
    surface->atlas.corners.push_back({first, first + glm::vec2(length, 0), first + glm::vec2(0, length)});
    const auto& [a, b, c] = mesh.triangles[t];
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const float v = float(x) / length, w = float(y) / length, u = 1 - v - w;
        const auto texel = std::size_t(low.y + y) * std::size_t(perRow * side) + std::size_t(low.x + x);
        surface->maps.triangle[texel] = std::uint32_t(t);
        surface->maps.position[texel] = glm::vec4(
            u * mesh.positions[a] + v * mesh.positions[b] + w * mesh.positions[c], u > -1e-4f ? 1.f : 0.5f);
        surface->maps.normal[texel] =
            glm::vec4(glm::normalize(u * mesh.normals[a] + v * mesh.normals[b] + w * mesh.normals[c]), 0);
      }
  }
  return surface;
}

// irradianceIn: a function of place and normal in every texel of a surface, premultiplied by coverage.
template <class F>
std::vector<glm::vec4> irradianceIn(const SkinSurface& surface, F&& f) {
  std::vector<glm::vec4> irradiance;
  for (std::size_t t = 0; t < surface.maps.position.size(); ++t) {
    const bool shown = surface.maps.position[t].w > 0;
    const float e = shown ? f(glm::vec3(surface.maps.position[t]), glm::vec3(surface.maps.normal[t])) : 0;
    irradiance.emplace_back(glm::vec3(e), shown ? 1.f : 0.f);
  }
  return irradiance;
}

}  // namespace sonoskin::test
