#pragma once

#include "core/skin/skin_material.h"
#include "render/skin/light_maps.h"
#include "render/skin/pass_programs.h"
#include "render/skin/skin_view.h"

namespace sonoskin {

// SkinTables: a material's tables as textures.
struct SkinTables {
  gl::Texture pigments, transmittance;
  SkinTables() = default;
  explicit SkinTables(const SkinMaterial& material);
};

// EnteringLight: the light that enters the skin and the skin's material, over the surface's atlas.
//   material -> light maps -> visibility -> irradiance
// None of it depends on the camera, nor on how light spreads below the surface.
class EnteringLight {
 public:
  EnteringLight();

  // fit: empty maps for another surface.
  void fit(const GpuSkin& surface);
  // adopt: what the passes draw from now on.
  void adopt(const SkinLook& look, const SkinQuality& quality);

  // The passes, in the order of work; light maps and visibility of one light each.
  void drawMaterial(const GpuSkin& surface);
  void drawLightMap(const GpuSkin& surface, std::size_t light);
  void drawVisibility(const GpuSkin& surface, std::size_t light);
  void drawIrradiance(const GpuSkin& surface);
  // giveBackMaps: the memory of depth maps, which only visibility and ThinModel::gaussians read. giveBackLight: also that of
  // the irradiance. Afterwards no pass can be drawn.
  void giveBackMaps();
  void giveBackLight();
  // set: a given irradiance in place of what the passes draw, on white skin.
  //   irradiance   per texel, linear RGB premultiplied by coverage in a
  void set(const std::vector<glm::vec4>& irradiance);

  const SkinLook& look() const { return look_; }
  const SkinMaterial& material() const { return skin_; }
  const SkinTables& tables() const { return tables_; }
  const LightMaps& lightMaps() const { return lightMaps_; }
  // irradiance: linear RGB premultiplied by coverage in a. albedo; finish: roughness, gloss, wetness, vernix.
  // visibility: of lights 0 to 2, open sky. thinness: of light 0's way through the body, see visibility.frag.
  const gl::Texture& irradiance() const { return irradiance_.colour(0); }
  const gl::Texture& albedo() const { return material_.colour(0); }
  const gl::Texture& finish() const { return material_.colour(1); }
  const gl::Texture& visibility() const { return visibility_.colour(0); }
  const gl::Texture& thinness() const { return visibility_.colour(1); }
  std::size_t bytes() const;

 private:
  PassPrograms programs_{"skin/atlas.vert"};
  LightMaps lightMaps_;
  SkinLook look_;
  SkinQuality quality_;
  SkinMaterial skin_;
  SkinTables tables_;
  gl::Texture specularTable_;
  gl::Framebuffer material_, visibility_, irradiance_;
};

}  // namespace sonoskin
