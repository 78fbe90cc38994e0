#pragma once

#include <memory>

#include "app/views/parts_scene.h"
#include "app/workspace/workspace.h"
#include "render/gpu_mask.h"
#include "render/gpu_mesh.h"
#include "render/gpu_volume.h"
#include "render/mesh_view.h"
#include "render/raycaster.h"

namespace sonoskin::ui {

// showsMesh, showsParts, wantsSkin: what the 3D view is to show. Skin takes a while to be prepared.
bool showsMesh(const Workspace& workspace);
bool showsParts(const Workspace& workspace);
bool wantsSkin(const Workspace& workspace);
std::shared_ptr<const Volume<float>> shownVolume(const Workspace& workspace);

// VolumeScene: a volume as the 3D view shows it.
//   cropMin, cropMax  0 to 1 along i, j, k: the crop box, and where asked for no more than what lies around the surface
struct VolumeScene {
  std::shared_ptr<const Volume<float>> volume;
  VolumeLook look = VolumeLook::surface;
  float level = 0.5f;
  glm::vec3 cropMin{0}, cropMax{1};
};
VolumeScene volumeScene(const Workspace& workspace);
// raycastInput: how it is drawn.
//   copy    of the volume on the GPU
//   erased  may be null
RaycastInput raycastInput(const VolumeScene& scene, GpuVolume& copy, const GpuMask* erased,
                          const Camera& camera, int raysPerPixel);

// MeshScene: a surface as the 3D view shows it, plainly lit or in the colours of its parts.
struct MeshScene {
  std::shared_ptr<const Mesh> mesh;
  MeshLook look = MeshLook::clay;
  float unseenShade = 0;
};
// meshScene: needs a mesh; `parts` keeps the coloured one.
MeshScene meshScene(PartsScene& parts, const Workspace& workspace);
MeshViewInput meshInput(const MeshScene& scene, const GpuMesh& copy, const Camera& camera, int supersampling);

}  // namespace sonoskin::ui
