#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "core/base/progress.h"
#include "core/volume/volume.h"

namespace sonoskin {

// DistanceFunction: a signed distance in the world, mm.
using DistanceFunction = std::function<double(const glm::dvec3& world)>;

// sampleDistance: a signed distance on a grid, exact to rounding near its zero set.
//   band     mm; nodes nearer than this to the surface hold the distance, those farther off only its sign and
//            a value beyond the band: the value at the middle of their block of 8^3 nodes
//   distance Lipschitz constant at most 1.25 around its zero set
//   cost     one evaluation per block and one per node of the blocks that the band touches
//   errors   Cancelled
Volume<float> sampleDistance(const Geometry& geometry, const DistanceFunction& distance, double band,
                             const Progress& progress = {});

// DistanceSample: a distance and its gradient (world, not normalised).
struct DistanceSample {
  float value;
  glm::vec3 gradient;
};

// DistanceGrid: trilinear look-up of a sampled distance, by world position; its axes are the world's. Clamped
// at the border.
class DistanceGrid {
 public:
  explicit DistanceGrid(Volume<float> samples);

  float value(const glm::vec3& world) const;
  DistanceSample sample(const glm::vec3& world) const;
  const Volume<float>& samples() const { return samples_; }

 private:
  struct Cell {
    const float* corner;
    glm::vec3 t;
  };
  Cell cellAt(const glm::vec3& world) const;

  Volume<float> samples_;
  glm::vec3 origin_, scale_, last_;
  std::ptrdiff_t row_, plane_;
};

}  // namespace sonoskin
