#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/mesh/mesh.h"

// The contents of mesh files. Input for all: a mesh that writeMesh has checked, world mm, LPS. PLY is our own code,
// because it carries our properties `visibility`, `measured` and `label`; the others are assimp's work, to which we add
// the marks of unit, frame and program that it has no place for. It leaves out triangles that use a vertex twice.
namespace sonoskin {

using Bytes = std::vector<std::uint8_t>;

// encodePly: binary, little-endian, mm; vertices float x y z, and nx ny nz, visibility, measured and uchar label where
// the mesh has them; faces uchar 3 and three ints. [Turk 1994]
Bytes encodePly(const Mesh& mesh);

// encodeStl: binary, mm; flat triangles with their normals.
//   errors   as exportScene
Bytes encodeStl(const Mesh& mesh);

// encodeObj: text, mm, nine digits (floats come back exactly); v, vn where the mesh has them, f.
Bytes encodeObj(const Mesh& mesh);

// encodeGlb: glTF 2.0 binary, metres, +Y up, front toward +Z: 0.001 (x, z, -y), a rotation; the normals are made where
// the mesh has none; _VISIBILITY where it has one; a plain skin-like material, seen from both sides.
//   errors   Error: more than 4 GB, which the format cannot hold
Bytes encodeGlb(const Mesh& mesh);

// write3mf: 3MF core, mm, z up, six digits. Goes to a file, because assimp cannot pack a 3MF in memory.
//   errors   Error (system): the file cannot be written
void write3mf(const std::filesystem::path& path, const Mesh& mesh);

}  // namespace sonoskin
