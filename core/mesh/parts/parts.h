#pragma once

#include "core/mesh/parts/part_graph.h"

namespace sonoskin {

// Part: what a person would take away or bring back as one.
//   area       mm²
//   centre     area-weighted, world mm; place: the place of the part nearest to it
//   curvature  mean over the part, 1/mm; > 0 where it bulges toward the outside, 1/radius on a ball
struct Part {
  double area = 0;
  glm::vec3 centre{0}, place{0};
  double curvature = 0;
};

// SurfaceParts: a surface cut into parts. Every part is connected.
//   ofTriangle  the number of each triangle's part
//   parts       largest area first
//   graph       patches of the surface, with the creases that the parts were found by
struct SurfaceParts {
  std::vector<std::uint32_t> ofTriangle;
  std::vector<Part> parts;
  PartGraph graph;
};

// cutParts: cuts a surface where people would: along hollows, through necks and strands.
//   mesh     one or many pieces, world mm
//   method   small patches; basins of a watershed on the creases between them; merged while no crease and no neck parts
//            them [Mangan and Whitaker 1999: Partitioning 3D surface meshes using watershed segmentation; Hoffman and Richards
//            1984 for the hollows; the necks and the strands, told by their normals, are ours]. Features below some 8 mm, and
//            the hollows of a face, are no borders: see MergeRules. Depends on lengths in mm
//   cost     O(n log n); 400k triangles in 0.13 s of one core
//   errors   Cancelled
SurfaceParts cutParts(const Mesh& mesh, const Progress& progress = {});

// describeParts: numbers parts anew, largest first, and fills in `parts` from `ofTriangle`, whose numbers may have gaps.
void describeParts(const Facets& facets, SurfaceParts& parts);

// triangleNearest: the triangle nearest to a point.
//   errors   Error: the surface is empty
std::uint32_t triangleNearest(const Mesh& mesh, const glm::vec3& point);

}  // namespace sonoskin
