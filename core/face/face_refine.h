#pragma once

#include "core/face/face_placement.h"
#include "core/face/face_space.h"

namespace sonoskin {

// SizePrior: how large heads are expected to be, as a factor of the first head.
struct SizePrior {
  float middle = 0.92f;
  float spread = 0.12f;  // of the logarithm
};

// RefineSteps: one round of refinement: steps, the model's points, mm at which a surface no longer pulls, from the first
// step to the last, and whether the modes of shape move.
struct RefineSteps {
  int steps = 8;
  std::size_t points = 160;
  float firstReach = 8, lastReach = 4;
  bool modes = false;
};

// refineFace: the placement nearby that fits the surfaces best.
//   solves   min sum w rho(n . (x - p)) + priors of size and modes: Gauss-Newton with Tukey's weights, point to plane
//            [Chen 1992; Tukey's biweight]; a model's point in free fluid is drawn from twice as far
//   output   `start` where too little is near
FacePlacement refineFace(const FacePlacement& start, const FaceSpace& space, const SizePrior& size,
                         const RefineSteps& steps);

}  // namespace sonoskin
