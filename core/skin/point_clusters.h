#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/base/progress.h"

namespace sonoskin {

// AreaPoints: points that share a surface among themselves; areas in mm^2.
struct AreaPoints {
  std::vector<glm::vec3> positions, normals;
  std::vector<float> areas;

  std::size_t size() const { return positions.size(); }
};

// PointClusters: points in clusters.
//   points      per cluster: its middle, mean normal and area
//   clusterOf   per point: the number of its cluster
//   variance    mm^2 per axis: how far the points lie from their clusters' middles
struct PointClusters {
  AreaPoints points;
  std::vector<std::uint32_t> clusterOf;
  double variance = 0;
};

// clusterPoints: clusters around points that are chosen at least `distance` mm apart; each point goes to the nearest one
// that faces about the same way. The middle of a cluster is its centre of mass, so that sums over clusters in place of
// points are right to the second order.
//   cost     1 million points into 150,000 clusters: 0.2 s on one core
//   errors   Cancelled
PointClusters clusterPoints(const AreaPoints& points, double distance, const Progress& progress = {});

}  // namespace sonoskin
