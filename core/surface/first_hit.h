#pragma once

#include <vector>

#include "core/surface/thinning.h"

namespace sonoskin {

// FluidLevels: what counts as fluid and as tissue in the low-passed volume.
//   iso    grey at the border of the skin: above is tissue
//   dark   below is fluid; between the two it is soft tissue, or the shadow of what lies before it
struct FluidLevels {
  float iso = 0, dark = 0;
};

// findFluidLevels: dark lies half-way from the fluid's grey to the iso-value. The fluid's is the median of what is
// darker than the iso-value within the view.
FluidLevels findFluidLevels(const Volume<float>& lowPassed, const FieldOfView& view, double iso);

// keepFirstHits: drops what shines through a surface, such as bone below skin.
//   rule     From a surface voxel one looks back along its beam toward the probe. It is dropped if within `depth` mm
//            one comes out of another surface: first through the dark before the voxel (v~ < iso), then through
//            tissue (v~ >= iso), to a border that has a surface voxel within a voxel. It stays if the dark before it
//            holds fluid (v~ < dark): then it is the border of something else that floats there, as a cheek behind a
//            finger; and if the way is longer: the wall of the uterus near the probe hides nothing behind it.
//            What lies outside the frame's region is not there: it counts as fluid.
//   voxels   in the order of memory; only these hide others
//   depth    mm; 0 keeps all
//   output   in the same order
//   errors   Cancelled
std::vector<SurfaceVoxel> keepFirstHits(const std::vector<SurfaceVoxel>& voxels,
                                        const Volume<float>& lowPassed, const ScanFrame& frame,
                                        const FluidLevels& levels, double depth,
                                        const Progress& progress = {});

}  // namespace sonoskin
