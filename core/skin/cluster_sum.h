#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/mesh/search/point_grid.h"
#include "core/skin/point_clusters.h"

namespace sonoskin {

// ClusterSum: the mean of what clusters of a surface carry, weighted by their areas and a Gaussian of their distance, for
// eight places at a time.
//   method   clusters within reach of the box around the places are added to all eight, one lane each; those beyond the
//            reach of a place, or that do not face its way (isLocal), weigh nothing there
class ClusterSum {
 public:
  static constexpr std::size_t kLanes = 8;

  ClusterSum() = default;
  // reach, variance   of the Gaussian, mm and mm^2: beyond the reach it is 0
  // readsPlane        the plane that fits best is read in the place of the mean: for clusters too far apart for a sum
  ClusterSum(const AreaPoints& clusters, double reach, double variance, bool readsPlane);

  // order: per cluster as it is kept, which number it had.
  const std::vector<std::uint32_t>& order() const { return grid_.order(); }
  std::size_t size() const { return grid_.order().size(); }
  float area(std::size_t cluster) const { return area_[cluster]; }
  float reach() const { return reach_; }

  // meansAt: at eight places or fewer, as near to each other as can be.
  //   input    light   per cluster as it is kept
  //   cost     30 instructions for a cluster and eight places, twice as many where planes are read
  void meansAt(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
               std::span<const glm::vec4> light, glm::vec4* means) const;
  // neighbours: how many clusters are within reach of one, itself among them.
  std::size_t neighbours(std::size_t cluster) const;
  std::size_t bytes() const { return area_.size() * (7 * sizeof(float) + sizeof(std::uint32_t)); }

 private:
  struct Eight;
  template <bool kPlane>
  void add(Eight& eight, std::span<const glm::vec4> light) const;
  std::uint32_t withinReach(const Eight& eight, std::size_t first, std::size_t last) const;
  std::size_t nearest(const glm::vec3& x) const;

  PointGrid grid_;
  std::vector<float> x_, y_, z_, nx_, ny_, nz_,
      area_;                        // in the order of the grid; a few more that are far away
  float reach_ = 0, exponent_ = 0;  // 2^(exponent r^2)
  bool readsPlane_ = false;
};

}  // namespace sonoskin
