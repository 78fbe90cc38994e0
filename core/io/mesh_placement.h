#pragma once

#include <array>
#include <string>

#include "core/io/file_formats.h"
#include "core/io/meshes/frame_tag.h"

namespace sonoskin {

constexpr std::array<const char*, 2> enumNames(MeshFrame) { return {"lps", "ras"}; }

enum class MeshUnit { millimetres, metres };
constexpr std::array<const char*, 2> enumNames(MeshUnit) { return {"mm", "m"}; }

// MeshPlacement: in which frame and unit the numbers of a mesh file are, where its format leaves them open.
//   frame  LPS as DICOM and ITK have it, or RAS as neuroimaging programs do; a half turn about the head's axis
struct MeshPlacement {
  MeshFrame frame = MeshFrame::lps;
  MeshUnit unit = MeshUnit::millimetres;
  friend bool operator==(const MeshPlacement&, const MeshPlacement&) = default;
};

// leavesPlacementOpen: PLY, STL, OBJ and VTP; GLB, 3MF and DICOM prescribe theirs.
bool leavesPlacementOpen(FileFormat format);

// placementText: for headers: "units mm, SPACE=LPS".
std::string placementText(const MeshPlacement& placement);

// placedMesh: the same surface in other numbers.
//   mesh  world mm, LPS
Mesh placedMesh(Mesh mesh, const MeshPlacement& placement);

}  // namespace sonoskin
