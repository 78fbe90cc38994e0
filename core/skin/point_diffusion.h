#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/skin/cluster_sum.h"
#include "core/skin/diffusion_places.h"
#include "core/skin/gaussian_sum.h"
#include "core/skin/point_clusters.h"

namespace sonoskin {

// PointDiffusion: light spreads from point to point on a surface, without an atlas.
//   method    the samples are gathered into base points 0.2 mm apart, these into clusters for each level, half a width of
//             its Gaussian apart. The light at a place is the Gaussian's sum over the level's clusters that face about the
//             same way: at folds that is asked once, and of the place itself. What clusters blur is taken off the Gaussian;
//             where they are too far apart for a sum, the plane through them is read.
//                                                                                                  [theory/skin.md, 6.3]
//   levels    1 to 5: the Gaussians number 1 to 5 of the sum; number 0 is narrower than the points. 6: see kSmooth
//   cost      100,000 triangles on 14,000 mm^2: built in 0.3 s of CPU, 25 MB
class PointDiffusion {
 public:
  static constexpr int kLevels = GaussianSum::kCount - 1;
  // kSmooth: one more level, which is no part of a profile: kSmoothVariance smooths the depth of thin parts.
  static constexpr int kSmooth = kLevels + 1;
  static constexpr double kSmoothVariance = 0.5625;  // mm^2
  static constexpr double kBaseSpacing = 0.2;        // mm
  using Levels = std::array<std::vector<glm::vec4>, kLevels>;

  // smoothLevel: that one of a profile's levels which is as wide as kSmooth to 3 %, which is kept in its place, or kSmooth.
  static int smoothLevel(const GaussianSum& profile);
  // varianceOf: of a level, mm^2.
  static double varianceOf(const GaussianSum& profile, int level);

  // errors   Error: no samples; Cancelled
  PointDiffusion(const AreaPoints& samples, const GaussianSum& profile, const Progress& progress = {});

  // resolves: whether a level is wide enough for the points to tell from no blur at all.
  bool resolves(int level) const { return levels_[std::size_t(level - 1)].resolved; }

  // meanNeighbours: how many clusters lightAt looks at for a place of a level that is resolved, on average: some 30 to 200 on a
  // surface, thousands where loose triangles fill a volume.
  double meanNeighbours(int level) const;

  // gather: what falls on each level's clusters; nothing for one that is not resolved.
  //   input    irradiance   per sample
  Levels gather(std::span<const glm::vec4> irradiance) const;
  std::vector<glm::vec4> gather(int level, std::span<const glm::vec4> irradiance) const;

  // addLightAt: adds a level's light at any places of the surface, times a weight; the level must be resolved.
  //   input    gathered   that level's
  //   output   sum        per place, in the order that they had before
  //   cost     0.1 to 0.2 us of CPU for a place
  //   errors   Cancelled
  void addLightAt(int level, std::span<const glm::vec4> gathered, const DiffusionPlaces& places,
                  const glm::vec4& weight, std::span<glm::vec4> sum, const Progress& progress = {}) const;
  // lightAt: that light alone.
  std::vector<glm::vec4> lightAt(int level, std::span<const glm::vec4> gathered,
                                 const DiffusionPlaces& places) const;

  std::size_t bytes() const;

 private:
  struct Level {
    ClusterSum clusters;
    std::vector<std::uint32_t> clusterOf;  // per sample
    bool resolved = false;
  };
  Level makeLevel(const PointClusters& clusters, const PointClusters& base, double variance) const;

  std::vector<float> areas_;  // of the samples
  std::array<Level, kSmooth> levels_;
};

}  // namespace sonoskin
