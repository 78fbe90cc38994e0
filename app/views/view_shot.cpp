#include "app/views/view_shot.h"

#include "core/base/error.h"
#include "render/gl/read_pixels.h"
#include "render/skin/baked_maps.h"

namespace sonoskin::ui {
namespace {

constexpr int kSamples = 2;  // along each side of a pixel

void draw(const VolumeScene& scene, const ViewShot& shot, const gl::Framebuffer& picture) {
  GpuVolume volume;
  volume.set(scene.volume);
  GpuMask erased;
  if (shot.erased) erased.set(*shot.erased, shot.erasedKey);
  Raycaster().draw(raycastInput(scene, volume, shot.erased ? &erased : nullptr, shot.camera, kSamples),
                   picture);
}

void draw(const MeshScene& scene, const ViewShot& shot, const gl::Framebuffer& picture) {
  GpuMesh mesh;
  mesh.set(scene.mesh);
  MeshView().draw(meshInput(scene, mesh, shot.camera, kSamples), picture);
}

void draw(const SkinShot& skin, const ViewShot& shot, const gl::Framebuffer& picture) {
  GpuSkin surface;
  surface.set(skin.surface);
  SkinShot finished = skin;
  finished.quality.diffusion = DiffusionMethod::points;
  SkinViews views;
  drawSkin(finished, shot.camera, surface, views, {.supersampling = kSamples}, picture);
}

}  // namespace

ViewShot takeShot(SpaceWindow& window, const Workspace& w) {
  ViewShot shot;
  shot.camera = w.view.camera;
  if (wantsSkin(w) && window.skin.shows(w)) {
    shot.shown = window.skin.shot(w);
  } else if (showsMesh(w)) {
    shot.shown = meshScene(window.parts, w);
  } else {
    shot.shown = volumeScene(w);
    const ErasedParts& erased = w.session.erased();
    if (erased.voxels() > 0) shot.erased = std::make_shared<const Volume<std::uint8_t>>(erased.mask());
    shot.erasedKey = erased.key();
  }
  return shot;
}

SkinShot takeSkinShot(const SpaceWindow& window, const Workspace& w) {
  require(window.skin.shows(w), "The skin is not ready yet; wait until the view shows it.");
  return window.skin.shot(w);
}

Image drawShot(const ViewShot& shot, glm::ivec2 size) {
  const gl::Framebuffer picture({.size = size});
  std::visit([&](const auto& scene) { draw(scene, shot, picture); }, shot.shown);
  return gl::readImage(picture);
}

TexturedMesh bakeShot(const SkinShot& shot, bool light) {
  GpuSkin surface;
  surface.set(shot.surface);
  const SkinLook look = lookOf(shot.settings, shot.home, surface.box());
  SkinQuality finished = shot.quality;
  finished.diffusion = light ? DiffusionMethod::points : DiffusionMethod::blurs;
  return bakeSurface(surface, look, {finished, light});
}

}  // namespace sonoskin::ui
