#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/skin/gaussian_sum.h"
#include "core/skin/skin_options.h"

namespace sonoskin {

// ProfileCurves: how far light goes below the skin, to be drawn over the distance.
//   radius   mm, 0 .. kReach, denser near 0
//   target   2 pi r R(r) / total, 1/mm: a channel's share that leaves per mm of distance; of the dipole, or
//            of the literature's Gaussians
//   fit      the same of the Gaussians that the pictures use
//   fitted   whether the two differ: not for the literature's
//   error    relative L2 with weight r; 0 unless fitted
struct ProfileCurves {
  static constexpr int kSteps = 300;
  static constexpr double kReach = 10;
  std::vector<double> radius;
  std::vector<glm::dvec3> target, fit;
  GaussianSum sum;
  bool fitted = false;
  glm::dvec3 error{0};
};

// makeProfileCurves: the curves of the options' profile and width; of width 0, where all light stays, they
// are 0.
//   cost     10 ms
ProfileCurves makeProfileCurves(const SkinOptions& options);

}  // namespace sonoskin
