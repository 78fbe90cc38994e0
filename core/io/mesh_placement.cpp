#include "core/io/mesh_placement.h"

#include <fmt/format.h>

namespace sonoskin {

bool leavesPlacementOpen(FileFormat format) {
  return format == FileFormat::ply || format == FileFormat::stl || format == FileFormat::obj ||
         format == FileFormat::vtp;
}

std::string placementText(const MeshPlacement& placement) {
  return fmt::format("units {}, SPACE={}", enumNames(placement.unit)[std::size_t(placement.unit)],
                     placement.frame == MeshFrame::ras ? "RAS" : "LPS");
}

Mesh placedMesh(Mesh mesh, const MeshPlacement& placement) {
  turnToLps(mesh, placement.frame);  // a half turn is its own way back
  if (placement.unit == MeshUnit::metres)
    for (glm::vec3& p : mesh.positions) p *= 0.001f;
  return mesh;
}

}  // namespace sonoskin
