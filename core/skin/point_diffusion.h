#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/point_grid.h"
#include "core/skin/gaussian_sum.h"
#include "core/skin/point_clusters.h"
#include "core/skin/sparse_rows.h"

namespace sonoskin {

// PointDiffusion: light spreads from point to point on a surface, without an atlas: for meshes that no atlas fits.
//   method    the samples are gathered into base points 0.3 mm apart, these into bunches for each level, about 0.8 widths
//             of its Gaussian apart. A level's points take their light from the level before the last by a Gaussian
//             of what is left to its own width, over points that face about the same way. What averaging into base points and
//             reading between points blur is measured and taken off the Gaussians.
//                                                            [skin specification, section 20.2; the measured widths: ours]
//   levels    1 to 5: the Gaussians number 1 to 5 of the sum; number 0 is narrower than the points
//   cost      100,000 triangles on 14,000 mm^2: built in 0.5 s of CPU, 70 MB; light again: 15 to 50 ms of CPU
class PointDiffusion {
 public:
  static constexpr int kLevels = GaussianSum::kCount - 1;
  static constexpr double kBaseSpacing = 0.3;  // mm
  using Levels = std::array<std::vector<glm::vec4>, kLevels>;

  // errors   Error: no samples; Cancelled
  PointDiffusion(const AreaPoints& samples, const GaussianSum& profile, const Progress& progress = {});

  // resolves: whether a level is wide enough for the points to tell from no blur at all.
  bool resolves(int level) const { return resolved_[std::size_t(level - 1)]; }

  // diffuse: the light at each level's own points.
  //   input    irradiance   per sample
  Levels diffuse(std::span<const glm::vec4> irradiance) const;

  // rowsTo: gives a level's light at other places of the surface, by moving least squares: linear light is kept.
  //   errors   Cancelled
  SparseRows rowsTo(int level, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                    const Progress& progress = {}) const;

  std::size_t bytes() const;

 private:
  struct Level {
    AreaPoints points;
    double spacing = 0;  // mm between points, mean
    PointGrid grid;
    SparseRows rows;  // from the level two before
  };
  static Level makeLevel(AreaPoints points);
  static SparseRows spread(const Level& from, const Level& to, double variance, const Progress& progress);
  double readingVariance(int level, const AreaPoints& places) const;

  SparseRows gather_;  // base points from samples
  std::array<Level, kLevels> levels_;
  std::array<bool, kLevels> resolved_{};
};

}  // namespace sonoskin
