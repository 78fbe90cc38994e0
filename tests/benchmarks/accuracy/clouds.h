#pragma once

#include <string>

#include "core/mesh/mesh.h"
#include "core/pipeline/parameters.h"
#include "core/surface/surface_points.h"

namespace sonoskin::accuracy {

// Cloud: points of a known surface as the chain finds them, at sub-voxel positions and rounded to whole voxels.
struct Cloud {
  std::string name;
  SurfacePoints refined, rounded;
  Mesh truth;
};

// phantomCloud: the points of the simulated scan at one noise level, with default parameters; those within 4 voxels of
// the skin that the probe sees, so that what else was found, and which piece is chosen, does not count.
Cloud phantomCloud(const std::string& level, double snr, const Parameters& parameters);

// sphereCloud: the ridge of a classified volume around a sphere of 30 mm in voxels of 0.5 mm.
//   jitter   RMS of the ridge's displacement, correlated over 1.5 voxels; voxels
//   method   f: signed distance plus jitter; u = 1/(1 + (f/1.5)²), grey (1 - tanh(f/2))/2, f in voxels; both with noise and
//            low-passed; then the chain's own thinning and normals
Cloud sphereCloud(double jitter);

}  // namespace sonoskin::accuracy
