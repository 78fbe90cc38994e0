#include "render/skin/points_light.h"

namespace sonoskin {
namespace {

// The thinness alone, after a level.
std::vector<glm::vec4> thinnessAfter(int level, const std::shared_ptr<const SkinSurface>& surface,
                                     const GaussianSum& profile, const EnteredLight& light,
                                     BlockDiffusion& kept, const Progress& progress) {
  SpreadWeights weights{};
  weights[std::size_t(level - 1)].a = 1;
  return diffuseInBlocks(surface, profile, light, weights, kept, progress);
}

}  // namespace

PointsLight spreadByPoints(const std::shared_ptr<const SkinSurface>& surface, const GaussianSum& profile,
                           ThinModel thin, EnteredLight light, BlockDiffusion& kept,
                           const Progress& progress) {
  PointsLight spread;
  if (thin == ThinModel::slab) {
    spread.sum = diffuseInBlocks(surface, profile, std::move(light), sumWeights(profile), kept, progress);
    return spread;
  }
  spread.levels = levelsInBlocks(surface, profile, {light.irradiance}, kept, progress.part(0, 0.7));
  for (int k = 0; k < 3; ++k)
    spread.thinness[std::size_t(k)] =
        thinnessAfter(2 + k, surface, profile, light, kept, progress.part(0.7 + 0.1 * k, 0.8 + 0.1 * k));
  return spread;
}

}  // namespace sonoskin
