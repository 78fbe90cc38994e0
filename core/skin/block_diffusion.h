#pragma once

#include <memory>

#include "core/skin/point_diffusion.h"
#include "core/skin/skin_surface.h"

namespace sonoskin {

// BlockDiffusion: what diffuseInBlocks keeps of a surface and a profile from one light to the next.
class BlockDiffusion {
 public:
  static constexpr std::size_t kMostSamples = 2'750'000;

  BlockDiffusion();
  ~BlockDiffusion();
  BlockDiffusion(BlockDiffusion&&) noexcept;
  BlockDiffusion& operator=(BlockDiffusion&&) noexcept;

  // bytes: memory that is kept.
  std::size_t bytes() const;
  // placesAsked: at how many places a level, 1 to 6, is asked; 0 where it leaves the light as it falls.
  std::size_t placesAsked(int level) const;

  struct State;
  std::unique_ptr<State> state;  // for diffuseInBlocks
};

// EnteredLight: maps over an atlas that are to be spread.
//   irradiance   per texel, linear, premultiplied by its coverage
//   thinness     per texel in r, premultiplied by its coverage in a: of thin parts, a value that is spread beside the light
//                (render/skin, EnteringLight::thinness); empty: 1 everywhere
struct EnteredLight {
  std::vector<glm::vec4> irradiance, thinness{};
};

// SpreadWeights: what levels 1 to 6 count for in a sum of them: rgb of light, a of the thinness.
using SpreadWeights = std::array<glm::vec4, PointDiffusion::kSmooth>;

// diffuseInBlocks: the light of an atlas of blocks after levels 1 to 6, weighted and summed, from point to point: an atlas
// whose triangles do not lie beside their neighbours cannot be blurred. Any other atlas will do too; its charts then show
// the same on both sides of a seam (ChartSides).
//   input    surface      the same object as before: what `kept` holds is used again
//   output   per texel that looks find (shownTexels), rgb: of light, a: of thinness; else 0. Gaussians narrower than points
//            0.2 mm apart can be leave the light as it is.
//   cost     350,000 triangles on 10,000 mm^2 with texels of 0.15 mm: 0.3 s of CPU once, 0.4 s for every light. However
//            large the surface, it has kMostSamples points, farther apart than 0.2 mm then: Gaussians narrower than that
//            leave the light as it is, too.
//   errors   Error: not one irradiance per texel; Cancelled
std::vector<glm::vec4> diffuseInBlocks(std::shared_ptr<const SkinSurface> surface, const GaussianSum& profile,
                                       EnteredLight light, const SpreadWeights& weights, BlockDiffusion& kept,
                                       const Progress& progress = {});

// levelWeights: of one level alone. sumWeights: of a profile, for the light of its levels 1 to 5 and smooth thinness.
SpreadWeights levelWeights(int level);
SpreadWeights sumWeights(const GaussianSum& profile);

// levelsInBlocks: each level alone.
PointDiffusion::Levels levelsInBlocks(const std::shared_ptr<const SkinSurface>& surface,
                                      const GaussianSum& profile, const EnteredLight& light,
                                      BlockDiffusion& kept, const Progress& progress = {});

}  // namespace sonoskin
