#pragma once

#include <string_view>

#include "core/mesh/mesh.h"

// The mark by which 3D Slicer and we say in a mesh file's header which frame its numbers are in: SPACE=LPS or SPACE=RAS.
namespace sonoskin {

enum class MeshFrame { lps, ras };

// frameIn: what the text of a header says; LPS where it says nothing, as 3D Slicer has it. Another frame is warned of.
MeshFrame frameIn(std::string_view header);

// frameNamed: of the value alone, as VTP keeps it.
MeshFrame frameNamed(std::string_view value);

// turnToLps: the same surface in LPS: x and y negated where it is in RAS, half a turn, so the winding stays.
void turnToLps(Mesh& mesh, MeshFrame from);

}  // namespace sonoskin
