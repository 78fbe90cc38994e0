#pragma once

#include <array>
#include <optional>

#include "app/views/cross_hair_marks.h"
#include "app/views/frame_share.h"
#include "app/views/orientation_cube.h"
#include "app/views/pane.h"
#include "app/views/picture_state.h"
#include "app/views/scene.h"
#include "app/views/skin_scene.h"
#include "app/views/tools.h"
#include "app/workspace/objects_seen.h"
#include "app/workspace/workspace.h"
#include "render/gl/gpu_timer.h"

namespace sonoskin::ui {

// GpuScans: the copies on the GPU that several views share; each is uploaded when a view first shows it.
struct GpuScans {
  GpuVolume raw, classified, thinned;
  std::array<GpuVolume, 3> slices;  // across i, j, k, of a slider's first answer
  GpuMask erased;
  bool ready = true;  // else what is to be shown is on its way, and views keep their pictures
};

// SpaceWindow: the 3D view. It keeps its picture and draws a new one only when what it shows has changed:
// with fewer pixels while the camera moves, in full when it rests.
//   compared  it is one of the ray-casts that are compared, of this layer
struct SpaceWindow {
  std::optional<SliceLayer> compared;
  std::optional<Raycaster> raycaster;  // made when first needed: shaders take a moment
  std::optional<MeshView> meshView;
  std::optional<gl::GpuTimer> timer;
  GpuMesh mesh;
  SkinScene skin;
  PartsScene parts;
  ToolState tools;
  OrientationCube cube;
  CrossHairSight sight;
  gl::Framebuffer picture, behind;  // behind: the surface within a translucent volume
  PictureState state;
  Key drawn;                      // of what the picture shows
  Key failed;                     // of what could not be drawn
  ObjectsSeen<3> from;            // what both are of
  float castRows = 0;             // of a volume that rests: the share of its rows that is cast
  double secondsPerPixel = 1e-6;  // of the last draw
  bool costKnown = false;         // that draw was one of the same objects
  double pictureSeconds = 0;      // of a picture in the last frame
  double draftSeconds = 0;        // of the last draft of something that moved
  FrameShare share;
  bool steered = false;  // something moves in this view itself
  double restsAt = 0;    // ImGui's time when a wheel's turn counts as over
};

inline constexpr double kWheelRests = 0.25;  // seconds without a turn

// drawSpaceWindow: the picture and its marks; turns what the mouse did into the camera.
//   output  seconds after which it wants a frame; negative for never
double drawSpaceWindow(SpaceWindow& window, GpuScans& scans, Workspace& workspace, const PaneInput& pane);

}  // namespace sonoskin::ui
