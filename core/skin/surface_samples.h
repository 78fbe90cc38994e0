#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// SurfaceSamples: places spread evenly over a surface, to integrate over it.
//   areas      mm^2 that each stands for; they add up to the surface's
//   triangles  where each lies, and weights: of that triangle's corners
//   spacing    mm, asked for
struct SurfaceSamples {
  std::vector<glm::vec3> positions, normals;
  std::vector<float> areas;
  std::vector<std::uint32_t> triangles;
  std::vector<glm::vec3> weights;
  float spacing = 0;

  std::size_t size() const { return positions.size(); }
};

// sampleSurface: the middles of the equal parts into which each triangle is cut. Linear functions are integrated
// exactly, and smooth ones to the second order however uneven the triangles are, which no random choice does.
//   input    spacing   mm, > 0; a sample stands for spacing^2 at most, its part is 2 spacings long at most
//   output   in the order of the triangles; triangles without area have none; slivers are cut along their length alone
//   cost     14,000 mm^2 at 0.11 mm: 1.6 million samples, 0.1 s on two cores
//   errors   Error: no triangles, spacing not above 0, more than 2^31 samples; Cancelled
SurfaceSamples sampleSurface(const Mesh& mesh, double spacing, const Progress& progress = {});

// affordableSpacing: the one asked for, or a larger one at which a surface has no more samples than `most`, one for each
// triangle aside.
double affordableSpacing(const Mesh& mesh, double spacing, std::size_t most);

}  // namespace sonoskin
