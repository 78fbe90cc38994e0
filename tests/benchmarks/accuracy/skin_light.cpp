#include "tests/benchmarks/accuracy/skin_light.h"

#include <cstdio>
#include <ctime>

#include "core/skin/atlas_reading.h"
#include "core/skin/block_diffusion.h"
#include "render/gl/read_pixels.h"
#include "render/skin/light_passes.h"
#include "render/skin/skin_view.h"

namespace sonoskin::accuracy {
namespace {

std::vector<glm::vec4> irradianceMap(const SkinSurface& surface, const SkinLighting& lighting) {
  std::vector<glm::vec4> map;
  for (std::size_t t = 0; t < surface.maps.position.size(); ++t) {
    const glm::vec4& p = surface.maps.position[t];
    const glm::vec3 n(surface.maps.normal[t]);
    map.push_back(p.w > 0 ? glm::vec4(glm::vec3(lighting(glm::vec3(p), n)), 1) : glm::vec4(0));
  }
  return map;
}

}  // namespace

glm::vec3 LitAtlas::at(const SkinPlace& place, const glm::vec3& irradiance) const {
  const glm::vec2 texel = placeInAtlas(surface->atlas.corners[place.triangle], place.weights);
  return glm::vec3(literatureSkin().weights[0]) * irradiance + readAtlas(diffused, surface->maps.size, texel);
}

LitAtlas litByPasses(std::shared_ptr<const SkinSurface> surface, const SkinLighting& lighting) {
  GpuSkin gpu;
  gpu.set(surface);
  SkinView view;
  SkinOptions plain;
  plain.colour = SkinColour::plain;
  plain.mix = plain.gloss = plain.translucency = 0;
  view.light().spread(gpu, plain, irradianceMap(*surface, lighting));
  return {std::move(surface), gl::readTexels(view.light().diffuser().result().map)};
}

LitAtlas litByPoints(std::shared_ptr<const SkinSurface> surface, const SkinLighting& lighting) {
  const auto seconds = [start = std::clock()] { return double(std::clock() - start) / CLOCKS_PER_SEC; };
  const std::vector<glm::vec4> irradiance = irradianceMap(*surface, lighting);
  const GaussianSum skin = literatureSkin();
  BlockDiffusion kept;
  const double before = seconds();
  const auto spread = [&] { return diffuseInBlocks(surface, skin, {irradiance}, sumWeights(skin), kept); };
  spread();
  const double built = seconds();
  std::vector<glm::vec4> sum = spread();
  std::fprintf(stderr,
               "points of %zu triangles in %zu texels: %.2f CPU-s once, %.3f for each light, %zu MB\n",
               surface->mesh->triangles.size(), irradiance.size(), built - before, seconds() - built,
               kept.bytes() >> 20);
  LitAtlas atlas{std::move(surface), std::move(sum)};
  for (glm::vec4& texel : atlas.diffused) texel.a = texel.a > 0 ? 1.f : 0.f;
  return atlas;
}

}  // namespace sonoskin::accuracy
