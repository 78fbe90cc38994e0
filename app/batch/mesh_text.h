#pragma once

#include <string>

#include "core/mesh/facts/mesh_facts.h"

namespace sonoskin {

// factsJson: the facts of a mesh as one JSON object: "closed", "manifold", "self_intersections", "volume_mm3", ...
std::string factsJson(const MeshFacts& facts);

// factsText: the same for people, some lines; the last says whether it can be printed.
std::string factsText(const MeshFacts& facts);

}  // namespace sonoskin
