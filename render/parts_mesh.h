#pragma once

#include <memory>
#include <vector>

#include "core/mesh/mesh.h"

namespace sonoskin {

// kPartColours: how many colours parts have; see shaders/surface/part_colours.glsl.
inline constexpr int kPartColours = 12;

// PartTint: the number of a part's colour, 0 (skin) to kPartColours - 1, and whether it is dimmed.
struct PartTint {
  int colour = 0;
  bool dimmed = false;
};

// makePartsMesh: a mesh for MeshLook::parts: its visibility holds the tints, and vertices between parts are there once
// for each, so that colours do not run into each other.
//   partOfTriangle  numbers below tints.size()
Mesh makePartsMesh(const Mesh& mesh, const std::vector<std::uint32_t>& partOfTriangle,
                   const std::vector<PartTint>& tints);

}  // namespace sonoskin
