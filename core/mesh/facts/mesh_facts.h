#pragma once

#include "core/base/progress.h"
#include "core/mesh/facts/mesh_check.h"

namespace sonoskin {

// MeshFacts: what a person and a slicer for 3D printing want to know of a mesh.
struct MeshFacts {
  MeshCheck check;
  std::size_t triangles = 0, pieces = 0;
  std::size_t selfIntersections = 0;  // pairs of triangles that cross
  double area = 0;                    // mm²
  double volume = 0;                  // mm³; 0 unless the mesh is closed
  glm::vec3 size{0};                  // of the bounding box, mm

  // printable: one or more solids without defects.
  bool printable() const {
    return triangles > 0 && check.closed() && check.manifold() && check.oriented() &&
           check.degenerateTriangles == 0 && selfIntersections == 0 && volume > 0;
  }
};

// measureMesh: all of it.
//   cost     1 million triangles: 3 s of one core
//   errors   Error: a triangle names a vertex that is not there; Cancelled
MeshFacts measureMesh(const Mesh& mesh, const Progress& progress = {});

}  // namespace sonoskin
