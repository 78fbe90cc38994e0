#pragma once

#include <functional>
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
  // placesAsked: at how many places a level, 1 to 5, is asked; 0 where it leaves the light as it falls.
  std::size_t placesAsked(int level) const;

  struct State;
  std::unique_ptr<State> state;  // for diffuseInBlocks
};

// diffuseInBlocks: the light of an atlas of blocks after levels 1 to 5, from point to point: an atlas whose triangles do
// not lie beside their neighbours cannot be blurred. Any other atlas will do too; its charts then show the same on both
// sides of a seam (ChartSides).
//   input    surface      the same object as before: what `kept` holds is used again
//            irradiance   per texel, linear, premultiplied by its coverage
//   output   per level and texel: rgb; a: 1 where the surface or the rim of a block is, else 0. Gaussians narrower than
//            points 0.2 mm apart can be leave the irradiance as it is.
//   cost     240,000 triangles on 7,000 mm^2: 0.2 s of CPU once; for every light 0.8 s with texels of 0.3 mm and 3 s with
//            texels of 0.15 mm. However large the surface, it has kMostSamples points, farther apart than 0.2 mm then:
//            Gaussians narrower than that leave the irradiance as it is, too.
//   errors   Error: not one irradiance per texel; Cancelled
PointDiffusion::Levels diffuseInBlocks(std::shared_ptr<const SkinSurface> surface, const GaussianSum& profile,
                                       const std::vector<glm::vec4>& irradiance, BlockDiffusion& kept,
                                       const Progress& progress = {});

// TakeLevel: is given one level's map after the other, 1 to 5, which may be moved from.
using TakeLevel = std::function<void(int level, std::vector<glm::vec4>& map)>;

// diffuseInBlocks: the same, but no more than one level's map is in memory at a time.
void diffuseInBlocks(std::shared_ptr<const SkinSurface> surface, const GaussianSum& profile,
                     const std::vector<glm::vec4>& irradiance, BlockDiffusion& kept, const TakeLevel& take,
                     const Progress& progress = {});

}  // namespace sonoskin
