#pragma once

#include <memory>

#include "app/views/parts_scene.h"
#include "app/workspace/shown_volume.h"
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

// VolumeScene: a volume as the 3D view shows it.
//   bytes    in the place of the volume: the thinned one
//   part     the crop box, and where asked for no more than what lies around the surface, before the plane that cuts
//   mesh     within it, may be null
struct VolumeScene {
  std::shared_ptr<const Volume<float>> volume{};
  std::shared_ptr<const Volume<std::uint8_t>> bytes{};
  VolumeLook look = VolumeLook::surface;
  float level = 0.5f;
  TransferFunction transfer{};
  bool shadows = true;
  GreyWindow window{};
  ShownPart part{};
  std::shared_ptr<const Mesh> mesh{};
};
VolumeScene volumeScene(const Workspace& workspace);
// comparedScene: a layer in the layout that compares ray-casts: all in the same way. Without a volume where it is not made yet.
VolumeScene comparedScene(const Workspace& workspace, SliceLayer layer);
// raycastInput: how it is drawn.
//   copy    of the volume on the GPU
//   erased  may be null
RaycastInput raycastInput(const VolumeScene& scene, GpuVolume& copy, const GpuMask* erased,
                          const Camera& camera);

// MeshScene: a surface as the 3D view shows it, plainly lit or in the colours of its parts.
struct MeshScene {
  std::shared_ptr<const Mesh> mesh;
  MeshLook look = MeshLook::clay;
  float unseenShade = 0;
  ClipPlane clip{};
};
// clipOf: the plane that cuts what is shown.
ClipPlane clipOf(const Workspace& workspace);
// meshWithin: the surface within a translucent volume, as it is drawn behind it.
MeshScene meshWithin(const VolumeScene& scene);
// meshScene: needs a mesh; `parts` keeps the coloured one.
MeshScene meshScene(PartsScene& parts, const Workspace& workspace);
MeshViewInput meshInput(const MeshScene& scene, const GpuMesh& copy, const Camera& camera, int supersampling);

}  // namespace sonoskin::ui
