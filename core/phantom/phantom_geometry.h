#pragma once

#include "core/phantom/phantom_options.h"
#include "core/phantom/sector_grid.h"
#include "core/volume/volume.h"

namespace sonoskin {

// phantomGeometry: the simulated scan's grid: `dims` voxels that fill the field of view, world axes.
//   errors   Error: an option is out of range
Geometry phantomGeometry(const PhantomOptions& options);

// anatomySpacing: mm; how finely to sample the anatomy for voxels of that size: 0.5 for the default ones.
double anatomySpacing(const Geometry& geometry);

// sceneSector: the probe's samples for the options' voxels, with the planes and the opening of their scene.
//   errors   as phantomGeometry
SectorGrid sceneSector(const PhantomOptions& options);

}  // namespace sonoskin
