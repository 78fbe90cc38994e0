#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// DistanceStatistics: how far the vertices of one mesh are from another surface; mm. Every vertex counts with the
// area around it, so that the result does not depend on how finely a region is meshed.
struct DistanceStatistics {
  std::size_t vertices = 0;  // measured
  double area = 0;           // that they stand for, mm²
  double mean = 0, rms = 0, p95 = 0, max = 0;
  double signedMean = 0, signedMedian = 0;  // positive outside the other surface, by its normals
  double normalAngle = 0;                   // mean angle between the normals, degrees
};

// MeshDistances: both ways, over everything and over what the probe can have seen.
//   visibleAToB   vertices of A whose closest place on B has visibility >= 0.5
//   visibleBToA   vertices of B with visibility >= 0.5
// Without visibility in B the last two equal the first two.
struct MeshDistances {
  DistanceStatistics aToB, bToA, visibleAToB, visibleBToA;
};

// measureDistances: exact distances from vertices to triangles, both ways.
//   a         the mesh to judge, for instance a reconstruction
//   b         the reference, for instance the true surface; its visibility says where it can be known
//   cost      500k vertices and as many triangles: 2 s on two cores
//   errors    Error: a mesh without triangles; Cancelled
//   threads   the result does not depend on their number
MeshDistances measureDistances(const Mesh& a, const Mesh& b, const Progress& progress = {});

}  // namespace sonoskin
