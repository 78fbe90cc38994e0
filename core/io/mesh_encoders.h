#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

// The bytes of mesh files. Input for all: a mesh that writeMesh has checked, world mm, LPS. All but OBJ are of known
// size beforehand; cost O(vertices + triangles).
// They are our own, and not a library's: each format needs a mark of unit and frame in its header, PLY and GLB carry
// a property of ours per vertex, and the writers of assimp, the one library in Debian 12, allow neither.
namespace sonoskin {

using Bytes = std::vector<std::uint8_t>;

// encodePly: binary, little-endian, mm; vertices float x y z, and nx ny nz and visibility where the mesh has them;
// faces uchar 3 and three ints. [Turk 1994]
Bytes encodePly(const Mesh& mesh);

// encodeStl: binary, mm; flat triangles with their normals.
Bytes encodeStl(const Mesh& mesh);

// encodeObj: text, mm, nine digits (floats come back exactly); v, vn where the mesh has them, f.
Bytes encodeObj(const Mesh& mesh);

// encodeGlb: glTF 2.0 binary, metres, +Y up, front toward +Z: 0.001 (x, z, -y), a rotation; the normals are made where
// the mesh has none; _VISIBILITY where it has one; a plain skin-like material, seen from both sides.
Bytes encodeGlb(const Mesh& mesh);

// encode3mf: 3MF core, mm, z up; triangles that use a vertex twice, which the standard forbids, are left out. Type
// "model" for a closed surface, "surface" for an open one.
Bytes encode3mf(const Mesh& mesh);

}  // namespace sonoskin
