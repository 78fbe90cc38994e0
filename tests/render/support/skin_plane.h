#pragma once

#include <functional>
#include <memory>

#include "core/skin/skin_surface.h"

namespace sonoskin {

// skinPlane: a square of `side` mm in the plane z = 0 that faces +z, as one chart in the middle of a map with an empty
// rim of 8 texels.
inline std::shared_ptr<const SkinSurface> skinPlane(float side, float texel) {
  auto surface = std::make_shared<SkinSurface>();
  auto mesh = std::make_shared<Mesh>();
  const float h = side / 2;
  mesh->positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
  mesh->normals.assign(4, {0, 0, 1});
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  constexpr int kRim = 8;
  const int inner = int(std::lround(side / texel)), width = inner + 2 * kRim;
  surface->atlas.size = surface->maps.size = {width, width};
  surface->atlas.texel = texel;
  surface->atlas.charts = 1;
  surface->atlas.chart = {0, 0};
  const auto place = [&](const glm::vec3& p) { return (glm::vec2(p) + h) / texel + float(kRim); };
  for (const Triangle& t : mesh->triangles)
    surface->atlas.corners.push_back(
        {place(mesh->positions[t[0]]), place(mesh->positions[t[1]]), place(mesh->positions[t[2]])});
  for (std::uint32_t v = 0; v < 4; ++v) {
    surface->vertices.uv.push_back(place(mesh->positions[v]) / float(width));
    surface->vertices.source.push_back(v);
  }
  surface->vertices.triangles = mesh->triangles;
  for (int y = 0; y < width; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::vec2 p = (glm::vec2(x, y) + 0.5f - float(kRim)) * texel - h;
      const bool covered = std::abs(p.x) < h && std::abs(p.y) < h;
      surface->maps.position.emplace_back(p, 0.f, covered ? 1.f : 0.f);
      surface->maps.normal.emplace_back(0, 0, 1, 0);
      surface->maps.occlusion.emplace_back(0, 0, 1, 1);
      surface->maps.stretch.emplace_back(texel);
    }
  surface->mesh = mesh;
  return surface;
}

// irradianceOn: an irradiance in the same map, white times value(x, y) in mm.
inline std::vector<glm::vec4> irradianceOn(const SkinSurface& plane,
                                           const std::function<double(double, double)>& value) {
  std::vector<glm::vec4> texels;
  for (const glm::vec4& p : plane.maps.position) {
    const float e = p.w > 0 ? float(value(double(p.x), double(p.y))) : 0.f;
    texels.emplace_back(glm::vec3(e), p.w > 0 ? 1.f : 0.f);
  }
  return texels;
}

}  // namespace sonoskin
