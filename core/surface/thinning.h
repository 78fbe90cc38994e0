#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/surface/region.h"
#include "core/surface/surface_options.h"
#include "core/volume/field_of_view.h"
#include "core/volume/scan.h"
#include "core/volume/volume.h"

namespace sonoskin {

// SurfaceVoxel: a voxel that is a maximum of the classified volume across the surface.
struct SurfaceVoxel {
  glm::ivec3 voxel;
  glm::vec3 position;  // in voxel indices, refined to a fraction of a voxel
  float value;         // u, > 0
  float facing = 1;    // cosine between the beam and the inward gradient
};

// ScanFrame: where the sound came from, how far the recording reaches, and what of it counts.
struct ScanFrame {
  Beam beam;
  FieldOfView view;
  Region region{};
};

// leastFacing: the cosine that thinning asks for: `facing`, or less where the sides of what faces the probe are wanted.
double leastFacing(const SurfaceOptions& options);

// thin: non-maximum suppression of the classified volume u across the surface.
//   direction   n = grad v~ of the low-passed volume, in millimetres: u is a ridge, whose own gradient flips
//   keeps       u(x) > u(x - d) and u(x) >= u(x + d), u >= threshold; d = n as a step of one voxel along its
//               longest axis; bilinear. One side may tie, so that a plateau of u gives one sheet: its dark side.
//   sub-voxel   parabola through the three values of 1/u, at most three quarters of a step
//   facing      keeps dark to bright along the beam: grad v~ . beam > facing |grad v~|; where options.sides are wanted,
//               down to -0.7, so that growSides() can choose
//   border      keeps what is at least borderMargin smallest spacings inside the field of view
//   output      in the order of the voxels
//   cost        467x255x124: 45 ms of one core; 28 bytes per voxel kept
//   errors      Cancelled
std::vector<SurfaceVoxel> thin(const Volume<float>& classified, const Volume<float>& lowPassed,
                               const ScanFrame& frame, const SurfaceOptions& options,
                               const Progress& progress = {});

}  // namespace sonoskin
