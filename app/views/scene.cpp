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

VolumeLook lookOf(VolumeStyle style) {
  switch (style) {
    case VolumeStyle::surface:
      return VolumeLook::surface;
    case VolumeStyle::translucent:
      return VolumeLook::translucent;
    case VolumeStyle::maximum:
      return VolumeLook::maximum;
  }
  return VolumeLook::surface;
}

// How a scene's volume is shown.
void show(VolumeScene& scene, const Workspace& w, VolumeStyle style, double level) {
  scene.look = lookOf(style);
  scene.level = static_cast<float>(level);
  scene.transfer = w.view.volume.transfer(scene.level);
  scene.shadows = w.view.volume.shadows;
  if (scene.volume == w.session.scan().volume) scene.window = w.view.grey;
  if (scene.volume || scene.bytes)
    std::tie(scene.part.cropMin, scene.part.cropMax) =
        shownPart(w, scene.volume ? scene.volume->geometry : scene.bytes->geometry);
  scene.part.clip = clipOf(w);
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

ClipPlane clipOf(const Workspace& w) { return w.view.clip.on ? w.view.clip.plane : ClipPlane{}; }

VolumeScene volumeScene(const Workspace& w) {
  const ViewState& v = w.view;
  VolumeScene scene{.volume = shownVolume(w)};
  show(scene, w, v.volumeStyle, shownLevel(v, w.session.results()));
  if (v.volume.mesh && v.volumeStyle == VolumeStyle::translucent) scene.mesh = w.session.results().mesh;
  return scene;
}

VolumeScene comparedScene(const Workspace& w, SliceLayer layer) {
  const Results& results = w.session.results();
  VolumeScene scene;
  if (layer == SliceLayer::raw) scene.volume = w.session.scan().volume;
  if (layer == SliceLayer::classified) scene.volume = results.classified;
  if (layer == SliceLayer::thinned) scene.bytes = results.thinned;
  show(scene, w, w.view.comparedStyle, levelOf(w.view, results, layer));
  return scene;
}

RaycastInput raycastInput(const VolumeScene& scene, GpuVolume& copy, const GpuMask* erased,
                          const Camera& camera) {
  return {.volume = copy,
          .camera = camera,
          .lighting = portraitLighting(camera),
          .look = scene.look,
          .iso = scene.level,
          .transfer = scene.transfer,
          .shadows = scene.shadows,
          .window = scene.window,
          .part = scene.part,
          .erased = erased};
}

MeshScene meshWithin(const VolumeScene& scene) {
  return {.mesh = scene.mesh, .look = MeshLook::clay, .clip = scene.part.clip};
}

MeshScene meshScene(PartsScene& parts, const Workspace& w) {
  if (showsParts(w)) return {parts.meshFor(w.session.results()), MeshLook::parts, 0, clipOf(w)};
  return {w.session.results().mesh, w.view.meshStyle == MeshStyle::clay ? MeshLook::clay : MeshLook::skin,
          w.view.unmeasured ? 1.0f : 0.0f, clipOf(w)};
}

MeshViewInput meshInput(const MeshScene& scene, const GpuMesh& copy, const Camera& camera,
                        int supersampling) {
  return {.mesh = copy,
          .camera = camera,
          .lighting = portraitLighting(camera),
          .look = scene.look,
          .supersampling = supersampling,
          .unseenShade = scene.unseenShade,
          .clip = scene.clip};
}

}  // namespace sonoskin::ui
