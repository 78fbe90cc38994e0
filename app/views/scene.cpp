#include "app/views/scene.h"

#include <algorithm>
#include <tuple>

#include "app/document/crop_box.h"
#include "app/document/part_edits.h"

namespace sonoskin::ui {
namespace {

constexpr float kCropMargin = 5;  // mm around the surface points

std::pair<glm::vec3, glm::vec3> shownPart(const Workspace& w, const Geometry& shown) {
  const auto box = boxIn(shown, w.session.parameters().region, w.session.scan().volume->geometry);
  const glm::dvec3 last = glm::max(glm::dvec3(shown.dims - 1), glm::dvec3(1));
  glm::vec3 least(glm::clamp(box[0] / last, 0.0, 1.0)), most(glm::clamp(box[1] / last, 0.0, 1.0));
  if (w.view.crop) {
    const auto around = cropTo(surroundings(w.session.scan(), w.session.results()), shown, kCropMargin);
    least = glm::max(least, around[0]);
    most = glm::max(glm::min(most, around[1]), least);
  }
  return {least, most};
}

}  // namespace

bool showsMesh(const Workspace& w) {
  return w.view.content == SpaceContent::mesh && w.session.results().mesh;
}

bool showsParts(const Workspace& w) {
  return w.view.parts && w.view.content == SpaceContent::mesh && hasParts(w.session.results());
}

bool wantsSkin(const Workspace& w) {
  return showsMesh(w) && !showsParts(w) && w.view.meshStyle == MeshStyle::skin;
}

std::shared_ptr<const Volume<float>> shownVolume(const Workspace& w) {
  const auto& classified = w.session.results().classified;
  return w.view.volumeLayer == VolumeLayer::classified && classified ? classified : w.session.scan().volume;
}

VolumeScene volumeScene(const Workspace& w) {
  VolumeScene scene{.volume = shownVolume(w)};
  scene.look = w.view.volumeStyle == VolumeStyle::surface ? VolumeLook::surface : VolumeLook::translucent;
  scene.level = static_cast<float>(shownLevel(w.view, w.session.results()));
  std::tie(scene.cropMin, scene.cropMax) = shownPart(w, scene.volume->geometry);
  return scene;
}

RaycastInput raycastInput(const VolumeScene& scene, GpuVolume& copy, const GpuMask* erased,
                          const Camera& camera, int raysPerPixel) {
  return {.volume = copy,
          .camera = camera,
          .lighting = portraitLighting(camera),
          .look = scene.look,
          .iso = scene.level,
          .transfer = amberTransfer(scene.level),
          .cropMin = scene.cropMin,
          .cropMax = scene.cropMax,
          .erased = erased,
          .raysPerPixel = static_cast<float>(raysPerPixel)};
}

MeshScene meshScene(PartsScene& parts, const Workspace& w) {
  if (showsParts(w)) return {parts.meshFor(w.session.results()), MeshLook::parts};
  return {w.session.results().mesh, w.view.meshStyle == MeshStyle::clay ? MeshLook::clay : MeshLook::skin,
          w.view.unmeasured ? 1.0f : 0.0f};
}

MeshViewInput meshInput(const MeshScene& scene, const GpuMesh& copy, const Camera& camera,
                        int supersampling) {
  return {.mesh = copy,
          .camera = camera,
          .lighting = portraitLighting(camera),
          .look = scene.look,
          .supersampling = supersampling,
          .unseenShade = scene.unseenShade};
}

}  // namespace sonoskin::ui
