#include "app/batch/scan_view.h"

#include <fmt/format.h>

#include <utility>

#include "app/document/face_view.h"
#include "app/document/input.h"
#include "app/document/transfer_file.h"
#include "app/document/view_planes.h"
#include "core/base/error.h"
#include "core/pipeline/face_use.h"
#include "render/camera.h"

namespace sonoskin {
namespace {

constexpr double kStrongClassified = 0.3;  // of the classified volume: what is seen as a surface

VolumeLook lookNamed(const std::string& mode) {
  return mode == "iso" ? VolumeLook::surface : mode == "mip" ? VolumeLook::maximum : VolumeLook::translucent;
}

// A preset of that name, else a file.
TransferFunction transferNamed(const std::string& name, float level) {
  if (const TransferPreset* preset = findTransferPreset(name)) return preset->at(level);
  return readTransfer(name).at(level);
}

Plane planeNamed(const std::string& name) {
  return name == "sagittal" ? Plane::sagittal : name == "coronal" ? Plane::coronal : Plane::axial;
}

bool showsSurface(const ScanView& view) { return view.view == "skin" || view.view == "mesh"; }

bool needsSurface(const VolumeShown& volume) { return !volume.whole || volume.withMesh; }

Image pictureOfVolumeIn(gl::Context& context, ScanMade& made, const ScanView& view,
                        const PictureOptions& picture) {
  const Region region = regionOf(made.scan, made.parameters.region);
  const bool classified = layerOf(view) == "classified";
  const VolumeShown& shown = view.volume;
  const double found = classified ? kStrongClassified : made.results.visibleLevel;
  VolumePictureOptions look = lookOf(shown, float(shown.level > 0 ? shown.level : found));
  if (classified) look.smoothing = 0;
  if (!shown.whole) look.crop = boxAround(*made.results.mesh);
  if (shown.withMesh) look.mesh = made.results.mesh;
  auto volume = classified ? made.results.classified : std::exchange(made.scan.volume, {});
  return pictureOfVolume(context, withinRegion(std::move(volume), region), look, picture);
}

Image pictureOfSlicesIn(gl::Context& context, const ScanMade& made, const ScanView& view, const Beam& beam) {
  const Scan& scan = made.scan;
  SlicesInput input{.raw = scan.volume,
                    .classified = made.results.classified,
                    .thinned = made.results.thinned,
                    .cursor = view.at,
                    .region = regionOf(scan, made.parameters.region),
                    .planes = planeAxes(scan.volume->geometry, viewFrameOf(scan, beam))};
  if (view.view == "slices") {
    if (!input.cursor) input.cursor = middleOf(*made.results.mesh);
    return pictureOfSlices(context, input, view.picture.size);
  }
  const std::string layer = layerOf(view);
  if (!input.cursor) input.cursor = brightMiddle(*scan.volume);
  if (layer != "thinned") input.thinned.reset();
  if (layer == "raw") input.classified.reset();
  input.rows = {planeNamed(view.plane)};
  input.lastAlone = true;
  return pictureOfSlices(context, input, view.picture.size);
}

}  // namespace

VolumePictureOptions lookOf(const VolumeShown& shown, float level) {
  VolumePictureOptions look;
  look.look = lookNamed(shown.mode);
  look.iso = level;
  if (look.look == VolumeLook::translucent) look.transfer = transferNamed(shown.transfer, level);
  if (look.look == VolumeLook::maximum) look.smoothing = 0;
  look.shadows = shown.shadows;
  return look;
}

std::string layerOf(const ScanView& view) {
  if (!view.layer.empty()) return view.layer;
  return view.view == "slice" ? "classified" : "raw";
}

std::optional<Goal> goalOf(const ScanView& view) {
  const std::string layer = layerOf(view);
  if (view.view == "slice") {
    if (layer == "raw") return {};
    return layer == "thinned" ? Goal::points : Goal::classified;
  }
  if (view.view != "volume" || needsSurface(view.volume)) return Goal::mesh;
  if (layer == "classified") return Goal::classified;
  return view.volume.level > 0 ? std::nullopt : std::optional(Goal::levels);
}

void requireWithin(const Scan& scan, const ScanView& view) {
  if (!view.at) return;
  constexpr double kHalf = 0.5001;  // of a voxel, and what rounding does
  const Geometry& g = scan.volume->geometry;
  const glm::dvec3 index = g.toIndex(*view.at), last(g.dims - 1);
  if (glm::all(glm::greaterThanEqual(index, glm::dvec3(-kHalf))) &&
      glm::all(glm::lessThanEqual(index, last + kHalf)))
    return;
  const auto words = [](const glm::dvec3& v) { return fmt::format("{:.1f},{:.1f},{:.1f}", v.x, v.y, v.z); };
  const Box box = worldBox(g);
  throw Error(
      fmt::format("--at {:g},{:g},{:g} lies outside of the scan, which reaches from {} to {} mm; give "
                  "a place within.",
                  view.at->x, view.at->y, view.at->z, words(box.min), words(box.max)),
      Error::Kind::usage);
}

SurfaceShot surfaceShot(const ScanMade& made, const ScanView& view) {
  SurfaceShot shot{made.results.mesh, made.parameters, view};
  const FaceFit* face =
      isCertain(made.results.face.get(), made.parameters.face) ? made.results.face.get() : nullptr;
  PictureOptions& picture = shot.view.picture;
  const float aspect = float(picture.size.x) / float(picture.size.y);
  picture.beam = beamOf(made.scan, made.parameters.scan);
  picture.face = cameraOnFace(shot.mesh->positions, face, picture.beam, aspect);
  shot.parameters.landmarks = landmarksWithFace(made.parameters, face);
  return shot;
}

Image pictureOfSurface(gl::Context& context, const SurfaceShot& shot, const Progress& progress) {
  const ScanView& view = shot.view;
  if (view.view == "mesh") return pictureOfMesh(context, shot.mesh, MeshLook::clay, view.picture);
  return pictureOfSkin(context, shot.mesh, shot.parameters, view.skin, view.picture, progress);
}

Image pictureOfScan(gl::Context& context, ScanMade made, const ScanView& view, const Progress& progress) {
  if (showsSurface(view)) return pictureOfSurface(context, surfaceShot(made, view), progress);
  PictureOptions picture = view.picture;
  picture.beam = beamOf(made.scan, made.parameters.scan);
  if (view.view == "volume") return pictureOfVolumeIn(context, made, view, picture);
  return pictureOfSlicesIn(context, made, view, picture.beam);
}

}  // namespace sonoskin
