#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/rbf/global/global_options.h"
#include "core/rbf/global/global_sites.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// GlobalPoints: what a global function has to interpolate: 0 on the surface, the signed distance beside it.
struct GlobalPoints {
  Sites sites;                 // mm; no two are equal
  std::vector<double> values;  // mm, > 0 outside
  std::size_t onSurface = 0;   // the first ones

  std::size_t size() const { return sites.size(); }
};

// makeGlobalPoints: the points, and for a share of them a point on either side along the normal.
//   rule     the distance is halved until the nearest point of the surface is the one it belongs to, so that it does
//            not reach through a thin part or over a gap; after six halvings the point is left out   [Carr et al. 2001]
//   input    equal points count once
//   cost     a search of a k-d tree per point off the surface and halving; 88k: 0.2 s
//   errors   Error: see checkPoints; Cancelled
GlobalPoints makeGlobalPoints(const SurfacePoints& points, const GlobalOptions& options,
                              const Progress& progress = {});

}  // namespace sonoskin
