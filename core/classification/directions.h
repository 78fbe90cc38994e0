#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/classification/slab.h"
#include "core/volume/volume.h"

namespace sonoskin {

// Directions: the normalised gradient g of the low-passed volume, in the cells between 2x2x2 voxels.
//   x, y, z  127 times g, per cell; cell (i,j,k) lies between voxels (i,j,k) and (i+1,j+1,k+1) and is stored
//            at voxel (i,j,k)'s index; 0 for the last i, j and k, which have no cell
struct Directions {
  Geometry geometry;
  LargeArray<std::int8_t> x, y, z;
};

// cellDirections: g = grad v~ / sqrt(|grad v~|^2 + kappa^2), quantised.
//   kappa    gradient per smallest spacing below which a direction fades
//   errors   Cancelled
Directions cellDirections(const Volume<float>& lowPassed, double kappa, const Progress& progress = {});

// setDirections: the same of some slices alone, as if the volume ended with them.
//   result   takes their geometry; its memory is used again
void setDirections(const Volume<float>& lowPassed, double kappa, const Slab& slab, Directions& result,
                   const Progress& progress = {});

}  // namespace sonoskin
