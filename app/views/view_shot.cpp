#include "app/views/view_shot.h"

#include <optional>

#include "core/base/error.h"
#include "render/skin/baked_maps.h"

namespace sonoskin::ui {
namespace {

constexpr int kSamples = 2;  // along each side of a pixel

Image draw(const VolumeScene& scene, const ViewShot& shot, const PictureOptions& options) {
  GpuVolume volume;
  volume.set(scene.volume);
  GpuMask erased;
  if (shot.erased) erased.set(*shot.erased, shot.erasedKey);
  GpuMesh mesh;
  mesh.set(scene.mesh);
  std::optional<MeshView> meshView;
  gl::Framebuffer behindPicture;
  if (scene.mesh) {
    meshView.emplace();
    behindPicture = gl::Framebuffer({.size = options.size});
  }
  Raycaster raycaster;
  return takePictures(options, shot.camera, [&](const Camera& camera, const gl::Target& target) {
    RaycastInput input = raycastInput(scene, volume, shot.erased ? &erased : nullptr, camera);
    input.raysPerPixel = kSamples;
    input.lighting.background = options.background;
    std::optional<SurfaceBehind> behind;
    if (meshView) {
      MeshViewInput within = meshInput(meshWithin(scene), mesh, camera, kSamples);
      within.lighting.background = options.background;
      meshView->draw(within, behindPicture);
      input.behind = &behind.emplace(SurfaceBehind{meshView->buffer(), behindPicture});
    }
    raycaster.draw(input, target);
  });
}

Image draw(const MeshScene& scene, const ViewShot& shot, const PictureOptions& options) {
  GpuMesh mesh;
  mesh.set(scene.mesh);
  MeshView view;
  return takePictures(options, shot.camera, [&](const Camera& camera, const gl::Target& target) {
    MeshViewInput input = meshInput(scene, mesh, camera, kSamples);
    input.lighting.background = options.background;
    view.draw(input, target);
  });
}

Image draw(const SkinShot& skin, const ViewShot& shot, const PictureOptions& options) {
  GpuSkin surface;
  surface.set(skin.surface);
  SkinShot finished = skin;
  finished.quality.diffusion = DiffusionMethod::points;
  finished.background = options.background;
  SkinViews views;
  return takePictures(options, shot.camera, [&](const Camera& camera, const gl::Target& target) {
    drawSkin(finished, camera, surface, views, {.supersampling = kSamples}, target);
  });
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

Image drawShot(const ViewShot& shot, const PictureOptions& options) {
  checkPictureSize(options.size);
  return std::visit([&](const auto& scene) { return draw(scene, shot, options); }, shot.shown);
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
