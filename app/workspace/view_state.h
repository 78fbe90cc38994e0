#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "app/document/measures.h"
#include "app/document/view_planes.h"
#include "app/workspace/tool.h"
#include "app/workspace/volume_show.h"
#include "core/pipeline/parameters.h"
#include "core/pipeline/pipeline.h"
#include "core/volume/scan.h"
#include "render/camera.h"
#include "render/skin/skin_view.h"
#include "render/slice_frame.h"
#include "render/slice_view.h"

namespace sonoskin {

enum class SliceLayer { raw, classified, thinned };
// layerName: for people, in English.
constexpr const char* layerName(SliceLayer layer) {
  constexpr std::array<const char*, 3> kNames{"Raw", "Classified", "Thinned"};
  return kNames[std::size_t(layer)];
}
enum class VolumeLayer { raw, classified };
enum class SpaceContent { volume, mesh };
enum class MeshStyle { clay, skin };

// Pane: one of the views.
enum class Pane { axial, space, sagittal, coronal, oblique };
// As 3D Slicer has them: row by row.
inline constexpr std::array<Pane, 4> kPanes{Pane::axial, Pane::space, Pane::coronal, Pane::sagittal};

// SlicePose: what part of one slice is seen; as in SliceCamera.
struct SlicePose {
  glm::dvec2 pan{0};
  double zoom = 1;
};

// SlicePlane: which slice a view shows: one of the three planes, or none of them: the oblique one.
using SlicePlane = std::optional<Plane>;

// ObliqueShow: the slice that can be turned; it goes through the cross-hair.
struct ObliqueShow {
  PlaneDirections directions;
  SlicePose pose{.pan = {0, 0}, .zoom = 0.92};
};

// SkinCompare: what the skin view's two halves show: one picture over both; without and with light that spreads below
// the surface; settings that were kept and the present ones.
enum class SkinCompare { off, scatter, settings };

// SkinSettings: what the skin's look depends on, kept to be compared.
struct SkinSettings {
  SkinOptions skin;
  LightOptions light;
  LandmarkOptions landmarks;
};

// SkinStatus: what the 3D view tells of the skin.
//   full          the quality in use
//   settled       the picture is the final one: with the light that was asked for, and all pixels
//   milliseconds  that a picture over the whole view takes; 0: not known yet
struct SkinStatus {
  bool full = false, settled = false;
  double milliseconds = 0;
};

// SkinShow: how the 3D view shows skin.
//   divider   between the halves, as a share of the view's width
//   lamp      the movable light's mark
//   reach     rings around the place in the middle: how far light spreads below the surface
//   places    marks of the landmarks
struct SkinShow {
  SkinPass pass = SkinPass::skin;
  SkinCompare compare = SkinCompare::off;
  float divider = 0.5f;
  std::optional<SkinSettings> kept;
  bool lamp = true, reach = false, places = false;
  SkinStatus status;
};

// ViewState: what the four views show and from where. Knows no interface and no OpenGL.
struct ViewState {
  glm::dvec3 cursor{0};  // where the three slices meet, world mm
  GreyWindow grey;       // of the raw slices
  SliceLayer layer = SliceLayer::raw;
  bool surfaceVoxels = true;
  bool cropBox = true;                  // its lines in all views
  std::array<SlicePose, 3> slices;      // by Plane
  Orientation orientation;              // of this document, as the person has it
  PlaneAxes planes;                     // what follows from it and the scan; the views bring it up to date
  SlicePlane pointedAt = Plane::axial;  // whose slice the mouse was over last: arrow keys are its
  ObliqueShow oblique;
  bool linkedZoom = false;       // all slices have as many mm per pixel
  double linkedScale = 0;        // that many; 0: as many as the slice that the mouse was over last
  bool classifiedTint = false;   // the classified volume in colour over raw slices
  bool slicePoints = false;      // the surface points that lie in a slice
  bool meshContour = true;       // where the surface meets a slice
  bool crossHairInSpace = true;  // its place and lines in 3D

  std::vector<Measure> measures;
  std::optional<Measure> measureBegun;  // that is being set
  MeasureKind measuring = MeasureKind::distance;

  SpaceContent content = SpaceContent::volume;
  VolumeStyle volumeStyle = VolumeStyle::surface;
  VolumeLayer volumeLayer = VolumeLayer::classified;
  bool crop = true;  // to the box around the surface points
  MeshStyle meshStyle = MeshStyle::skin;
  bool unmeasured = false;  // marked on mesh and skin: what was filled in or lies at the border of the data
  bool parts = false;       // the mesh in the colours of its parts, which can be taken away and brought back
  VolumeStyle comparedStyle = VolumeStyle::translucent;  // of the ray-casts that are compared
  std::optional<double>
      volumeLevel;  // the ray-caster's iso-value or the middle of its ramp; empty: the pipeline's
  SkinShow skin;
  VolumeShow volume;
  ClipShow clip;
  Camera camera;
  bool turntable = false;    // the camera goes round and round what it looks at
  bool cameraMoved = false;  // by the person, since it was last reset

  // What a person has chosen for the left button; where it is the cross-hair, what is shown has a say: see useTool.
  Tool sliceTool = Tool::crossHair, spaceTool = Tool::crossHair;
  double brushRadius = 6;    // of the eraser, mm
  std::size_t landmark = 0;  // that is placed next; see kLandmarks
  bool toolHeld = false;     // by the left button, in any view: the 3D view draws drafts

  // trail: where the mouse was in the window since the frame before; what is drawn by hand goes through it.
  std::vector<glm::vec2> trail;
  double lassoDepth =
      0;  // mm behind what is seen first, or to both sides of a slice, that a lasso cuts; 0: all

  std::optional<Pane> maximised;
  // catchingUp: this frame is not shown, for input of another one waits; the views keep their pictures.
  bool catchingUp = false;
  double frameSeconds = 0;  // that the window worked at its last frame
};

// kLeastBrush, kMostBrush: the smallest and the largest ball of the eraser, mm.
inline constexpr double kLeastBrush = 1, kMostBrush = 40;

// levelOf: the grey value at which the ray-caster sees a surface in a layer: the person's where it is of that layer, else the
// visible level that the pipeline used or, in what the classification made, what makes a strong surface voxel.
// shownLevel: that of the layer that the 3D view shows.
double levelOf(const ViewState& view, const Results& results, SliceLayer layer);
double shownLevel(const ViewState& view, const Results& results);

// surroundings: the part of the world that the 3D view is about: around the surface points, else the whole volume.
Box surroundings(const Scan& scan, const Results& results);

// cropTo: a box of the world as shares of a volume, 0 to 1 along i, j, k, with a margin in mm.
std::array<glm::vec3, 2> cropTo(const Box& box, const Geometry& geometry, float margin);

// resetView: cross-hair to the middle, slices whole, camera on the probe's side or before the patient. resetCamera: the camera
// alone.
void resetView(ViewState& view, const Scan& scan, const Beam& beam);
void resetCamera(ViewState& view, const ViewFrame& frame, const Box& box);
// resetOblique: as the axial plane.
void resetOblique(ViewState& view, const Geometry& geometry);
// turnView: turns what the slices of a plane show clockwise by a quarter, and with it all views.
void turnView(ViewState& view, const ViewFrame& frame, Plane plane);
// turnCamera: the camera is turned about what it looks at by what has come to the frame's turn.
void turnCamera(Camera& camera, const ViewFrame& before, const ViewFrame& after);

}  // namespace sonoskin
