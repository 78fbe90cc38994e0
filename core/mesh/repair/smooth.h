#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// smoothMesh: takes away noise; edges and the enclosed volume stay.
//   steps    0 changes nothing
//   output   the same triangles; normals made anew where the mesh has them
//   method   each step: the triangles' normals become means of those around them, weighted by area, distance and
//            likeness (bilateral, widths: mean distance of neighbours; 0.35 between unit normals); then ten times the
//            vertices follow the normals.    [Zheng, Fu, Au, Tai 2011, local scheme; vertices: Sun, Rosin 2007]
//            Vertices of a border move along the border only.
//   cost     1 million triangles: 0.3 s per step on one core
//   threads  the result does not depend on their number
//   errors   Cancelled
void smoothMesh(Mesh& mesh, int steps, const Progress& progress = {});

}  // namespace sonoskin
