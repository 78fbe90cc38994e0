#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/mesh/search/point_grid.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// SupportLimits: where a surface ends.
//   spacing    of the points, mm, > 0
//   gap        mm from the nearest point, > 0
//   coverage   Σφ; 0: anywhere
//   density    share of the points' usual density, 0 to 1; 0: anywhere. 0.5 is what a straight border of points has
struct SupportLimits {
  float spacing = 1, gap = 1, coverage = 0, density = 0;
};

// SupportMargin: how far a place of the surface is from where it would be cut off.
//   density   ρ(x) = Σ_j (1 - |x - p_j|²/r²)² [n·n_j > 0.3] over points closer than r = 5 spacings, as a share of its
//             median at the points themselves: 1 amid points, 1/2 at a straight border of theirs, less on tongues and
//             around strays. Points of another sheet behind do not count
//   errors    none; without points nothing is supported
class SupportMargin {
 public:
  static constexpr float kBand = 0.5f;

  SupportMargin(const SurfacePoints& points, const SupportLimits& limits);

  // Nearby: the points that count around one centre, gathered once for many places near it.
  struct Nearby {
    std::size_t count = 0;
    std::vector<float> x, y, z, nx, ny, nz;
    void makeRoom(std::size_t more);
  };
  // gather: what at() needs for places within `reach` of a centre.
  void gather(const glm::vec3& centre, float reach, Nearby& nearby) const;

  // Place: what the margin says of one place.
  //   value     in [-kBand, kBand], > 0 where the surface stays: the least of (gap - distance)/gap, (Σφ - limit)/limit
  //             and (ρ - limit)/0.6
  //   isBeyond  no point is within the gap, or the coverage is below its limit: nothing is known of the surface here
  struct Place {
    float value;
    bool isBeyond;
  };
  Place at(const glm::vec3& position, const glm::vec3& normal, float coverage, const Nearby& nearby) const;

  // mayStay: false only if at() is -kBand everywhere within `reach` of a centre.
  bool mayStay(const glm::vec3& centre, float reach) const;

 private:
  struct Sums {
    float density, distance;
  };
  Sums sumsAt(const glm::vec3& position, const glm::vec3& normal, const Nearby& nearby) const;
  void findUsualDensity();

  SupportLimits limits_;
  float radius_, farthest_, usual_ = 1;
  PointGrid grid_;
  std::vector<glm::vec3> positions_, normals_;  // sorted
};

}  // namespace sonoskin
