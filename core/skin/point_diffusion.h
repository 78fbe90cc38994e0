#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/search/point_grid.h"
#include "core/skin/gaussian_sum.h"
#include "core/skin/point_clusters.h"

namespace sonoskin {

// PointDiffusion: light spreads from point to point on a surface, without an atlas.
//   method    the samples are gathered into base points 0.2 mm apart, these into clusters for each level, half a width of
//             its Gaussian apart. The light at a place is the Gaussian's sum over the level's clusters that face about the
//             same way: at folds that is asked once, and of the place itself. What clusters blur is taken off the Gaussian;
//             where they are too far apart for a sum, the plane through them is read.
//                                                                                                  [theory/skin.md, 6.3]
//   levels    1 to 5: the Gaussians number 1 to 5 of the sum; number 0 is narrower than the points
//   cost      100,000 triangles on 14,000 mm^2: built in 0.3 s of CPU, 25 MB
class PointDiffusion {
 public:
  static constexpr int kLevels = GaussianSum::kCount - 1;
  static constexpr double kBaseSpacing = 0.2;  // mm
  using Levels = std::array<std::vector<glm::vec4>, kLevels>;

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

  // lightAt: a level's light at any places of the surface; the level must be resolved.
  //   input    gathered   that level's
  //   cost     0.9 to 1.6 us of CPU for a place
  //   errors   Cancelled
  std::vector<glm::vec4> lightAt(int level, std::span<const glm::vec4> gathered,
                                 std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                 const Progress& progress = {}) const;

  std::size_t bytes() const;

 private:
  struct Level {
    AreaPoints points;  // in the order of the grid
    PointGrid grid;
    std::vector<std::uint32_t> clusterOf;  // per sample
    float reach = 0, exponent = 0;         // of the Gaussian
    bool readsPlane = false, resolved = false;
  };
  Level makeLevel(const PointClusters& clusters, const PointClusters& base, double variance) const;

  std::vector<float> areas_;  // of the samples
  std::array<Level, kLevels> levels_;
};

}  // namespace sonoskin
