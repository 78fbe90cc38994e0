#pragma once

#include <array>
#include <vector>

#include "core/skin/block_diffusion.h"
#include "core/skin/skin_options.h"

namespace sonoskin {

// PointsLight: light over an atlas that was spread from point to point.
//   sum      rgb: of levels 1 to 5, a: the smooth thinness; all that plates need
//   levels   for ThinModel::gaussians: each level, and the thinness as it is before levels 3, 4 and 5, in a
struct PointsLight {
  std::vector<glm::vec4> sum;
  PointDiffusion::Levels levels;
  std::array<std::vector<glm::vec4>, 3> thinness;
};

// spreadByPoints: by diffuseInBlocks.
PointsLight spreadByPoints(const std::shared_ptr<const SkinSurface>& surface, const GaussianSum& profile,
                           ThinModel thin, EnteredLight light, BlockDiffusion& kept,
                           const Progress& progress = {});

}  // namespace sonoskin
