#pragma once

#include <cstdint>
#include <memory>

#include "core/surface/edge_placement.h"
#include "core/surface/surface_points.h"
#include "core/volume/volume.h"

namespace sonoskin {

// FoundPoints: what was found of the surface in the classified volume.
//   thinned  u as 1..255 on surface voxels, 0 elsewhere
//   edge     across the surface, where the points were moved onto it
struct FoundPoints {
  std::shared_ptr<const Volume<std::uint8_t>> thinned;
  std::shared_ptr<const SurfacePoints> points;
  EdgeProfile edge;
};

}  // namespace sonoskin
