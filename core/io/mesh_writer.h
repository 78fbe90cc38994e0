#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/dicom/dicom_patient.h"
#include "core/io/mesh_placement.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// MeshFileOptions: what a file says beside the surface.
//   patient    whom a DICOM file is about; the other formats say nobody's name
//   placement  of the formats that leave it open; the others keep to their own
struct MeshFileOptions {
  DicomPatient patient{};
  MeshPlacement placement{};
};

// writeMesh: writes a mesh in the format of the name's extension (FileKind::writtenMesh), atomically. The headers of PLY, STL,
// OBJ and VTP say "units mm, SPACE=LPS", or the placement that is asked for; GLB is in metres with +Y up and 3MF in mm, as
// their standards want (mesh_encoders.h).
//   input    mesh     world mm, LPS; normals, visibility and labels are kept where the format can hold them
//   errors   Error (usage): another extension, a patient's data that DICOM does not allow; Error: no triangles, positions
//            that are not finite, indices or arrays that do not fit together; (system) the file cannot be written; Cancelled
void writeMesh(const std::filesystem::path& path, const Mesh& mesh, const Progress& progress = {});
void writeMesh(const std::filesystem::path& path, const Mesh& mesh, const MeshFileOptions& options,
               const Progress& progress = {});

}  // namespace sonoskin
