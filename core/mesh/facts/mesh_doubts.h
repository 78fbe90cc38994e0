#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// meshDoubts: why a surface may not be what it should be, a sentence each: its size is that of another unit than mm; it is
// inside out.
//   method  a head, or what is seen of it, is 2 cm to 1 m across; the volume between the triangles and the middle of the
//           surface is negative where most of them look inward
std::vector<std::string> meshDoubts(const Mesh& mesh);

// requireExtent: refuses a surface larger than a house (100 m) or so far away that floats cannot tell its lengths apart.
//   name    of its file, for people
//   errors  Error: it is one of these
void requireExtent(const Mesh& mesh, const std::string& name);

// pairDoubts: why two surfaces may not share frame or unit: their boxes do not touch, or one is five times as large.
std::vector<std::string> pairDoubts(const Mesh& a, const Mesh& b);

// scaleMesh, flipMesh: what mends these: other lengths; the other side outward.
//   errors  Error: what requireExtent refuses
void scaleMesh(Mesh& mesh, float factor);
void flipMesh(Mesh& mesh);

}  // namespace sonoskin
