#pragma once

#include "core/surface/edge_placement.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// SurfaceInput: what the surface is found in. All volumes have the same geometry.
//   recorded    grey in [0, 1]
//   classified  u
//   lowPassed   v~, of the recorded
//   isoValue    grey at the border of the skin, as the classification had it
struct SurfaceInput {
  const Volume<float>&recorded, &classified, &lowPassed;
  ScanFrame frame;
  double isoValue = 0.3;
};

// FoundSurface: the surface as points, and the voxels in which they were found.
struct FoundSurface {
  std::vector<SurfaceVoxel> voxels;
  SurfacePoints points;
  EdgeProfile edge;  // across the surface; all zero without SurfaceOptions::offsetCorrection
};

// findSurface: from the classified volume to oriented points on the skin.
//   steps    thin, the frame's region, dropWeakClusters, keepFirstHits, dropWeakClusters, dropLooseLobes,
//            extractSurfacePoints, placeOnEdges
//   scale    with ThresholdScale::strongest the thresholds are shares of the 99.8th percentile of u: soft edges classify
//            weakly all over a volume, so what counts is how strong a surface is beside the others
//   region   what is left of the surface is weighed by itself; the thresholds are those of the whole volume, so that a
//            cut moves nothing that stays
//   output   no points where nothing is found
//   cost     467x255x124: 90 ms of one core
//   errors   Cancelled
//   threads  the result does not depend on their number
FoundSurface findSurface(const SurfaceInput& input, const SurfaceOptions& options,
                         const Progress& progress = {});

}  // namespace sonoskin
