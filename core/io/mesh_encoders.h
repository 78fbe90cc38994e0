#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/io/dicom/dicom_patient.h"
#include "core/io/mesh_placement.h"
#include "core/mesh/mesh.h"

// The contents of mesh files. Input for all: a mesh that writeMesh has checked, world mm, LPS; where a placement is given, it
// is in that already, and the header says so. PLY is our own code,
// and so is VTP, because they carry our properties `visibility`, `measured` and `label`; STL, OBJ, GLB and 3MF are assimp's work, to
// which we add the marks of unit, frame and program that it has no place for. It leaves out triangles that use a vertex twice.
namespace sonoskin {

using Bytes = std::vector<std::uint8_t>;

// encodePly: binary, little-endian, mm; vertices float x y z, and nx ny nz, visibility, measured and uchar label where
// the mesh has them; faces uchar 3 and three ints. [Turk 1994]
Bytes encodePly(const Mesh& mesh, const MeshPlacement& placement = {});

// encodeVtp: VTK's XML for polygons, mm, packed by zlib in letters; SPACE says LPS in the field data; Normals, visibility,
// measured and label where the mesh has them. [VTK file formats, "XML file formats"]
Bytes encodeVtp(const Mesh& mesh, const MeshPlacement& placement = {});

// encodeStl: binary, mm; flat triangles with their normals.
//   errors   as exportScene
Bytes encodeStl(const Mesh& mesh, const MeshPlacement& placement = {});

// encodeDicomStl: encodeStl's file as a DICOM Encapsulated STL, in mm, with UIDs of its own. Without a given patient it says
// nobody's name, and nothing of the examination in any case.  [DICOM PS3.3, A.85; Supplement 205]
//   errors   Error: more than 4 GB, which the format cannot hold; (usage) as requireSound
Bytes encodeDicomStl(const Mesh& mesh, const DicomPatient& patient);

// encodeObj: text, mm, nine digits (floats come back exactly); v, vn where the mesh has them, f.
Bytes encodeObj(const Mesh& mesh, const MeshPlacement& placement = {});

// encodeGlb: glTF 2.0 binary, metres, +Y up, front toward +Z: 0.001 (x, z, -y), a rotation; the normals are made where
// the mesh has none; _VISIBILITY where it has one; a plain skin-like material, seen from both sides.
//   errors   Error: more than 4 GB, which the format cannot hold
Bytes encodeGlb(const Mesh& mesh);

// write3mf: 3MF core, mm, z up, six digits. Goes to a file, because assimp cannot pack a 3MF in memory.
//   errors   Error (system): the file cannot be written
void write3mf(const std::filesystem::path& path, const Mesh& mesh);

}  // namespace sonoskin
