#pragma once

#include <cstddef>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// MeshCheck: what a slicer for 3D printing asks of a mesh.
struct MeshCheck {
  std::size_t usedVertices = 0;         // vertices of at least one triangle
  std::size_t edges = 0;                // undirected
  std::size_t boundaryEdges = 0;        // in one triangle only
  std::size_t nonManifoldEdges = 0;     // in more than two
  std::size_t misorientedEdges = 0;     // in two triangles that run along it the same way
  std::size_t nonManifoldVertices = 0;  // whose triangles form more than one fan
  std::size_t degenerateTriangles = 0;  // with a repeated vertex or without area
  std::ptrdiff_t euler = 0;             // V - E + F: 2 for each closed shell without handles

  bool closed() const { return boundaryEdges == 0; }
  bool manifold() const { return nonManifoldEdges == 0 && nonManifoldVertices == 0; }
  bool oriented() const { return misorientedEdges == 0; }
};

// checkMesh: counts the defects of a mesh.
//   cost     O(n) time, 16 bytes per half-edge; 1 million triangles in a quarter of a second
//   errors   Error: a triangle names a vertex that is not there; Cancelled
MeshCheck checkMesh(const Mesh& mesh, const Progress& progress = {});

// defectiveVertices: those at which the mesh is not manifold or not oriented, in ascending order.
//   errors   Error: a triangle names a vertex that is not there
std::vector<std::uint32_t> defectiveVertices(const Mesh& mesh);

// enclosedVolume: mm^3, positive if the triangles are counter-clockwise seen from outside; for closed meshes.
double enclosedVolume(const Mesh& mesh);

}  // namespace sonoskin
