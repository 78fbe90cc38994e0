#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace sonoskin {

// HullFace: a flat part of a hull: points p with normal . p + offset <= 0 are inside.
struct HullFace {
  glm::dvec3 normal{0};  // unit, outward
  double offset = 0;     // mm
  double area = 0;       // mm²
};

// convexHull: the faces of the smallest convex body around some points.
//   points   mm
//   merging  radians; faces whose normals differ by less from that of a larger one become one with it: a plane of their
//            mean direction that touches the body, so that it lies within it nowhere
//   output   largest area first; none for points without volume
//   method   quickhull (qhull)  [Barber, Dobkin, Huhdanpaa 1996]
//   cost     O(n log n): 50,000 points in 40 ms
std::vector<HullFace> convexHull(std::vector<glm::dvec3> points, double merging);

// HullEdge: the same in a plane.
struct HullEdge {
  glm::dvec2 normal{0};
  double offset = 0, length = 0;
};

// convexOutline: the edges of the smallest convex polygon around some points, in their order around it.
//   merging  as above
//   output   none for points without area
std::vector<HullEdge> convexOutline(std::vector<glm::dvec2> points, double merging);

}  // namespace sonoskin
