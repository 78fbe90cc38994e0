#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/phantom/phantom_options.h"
#include "core/volume/volume.h"

namespace sonoskin::accuracy {

// Interface: a signed distance to one of the phantom's surfaces, world mm, positive in the fluid.
using Interface = std::function<double(const glm::dvec3& world)>;

// signedDistance: from `world` to the nearest point of an interface, when lengths along the axes are measured in
// units of `unit` mm: the voxels' spacing for distances in voxels, 1 for distances in millimetres.
//   method   the tangent plane at the last foot point gives the next one, at most 12 times
//   output   positive in the fluid; `foot` is the nearest point, world mm; kFar beyond 8 mm
inline constexpr double kFar = 1e9;
double signedDistance(const Interface& interface, const glm::dvec3& world, const glm::dvec3& unit,
                      glm::dvec3* foot = nullptr);

class PointTree;

// Truth: the surfaces that a method should find in the simulated scan, whatever the noise.
// A fluid-tissue surface is the skin of the baby where it is not pressed into the mother's tissue
// (skin = 0, other >= 0), and the wall of the uterus, the placenta and whatever else the scene has where they face the
// fluid (other = 0, skin >= 0; PhantomModel). Distances in voxels are taken in index space, in which a voxel is a
// cube, as the figures were from which the bars of this program come.
class Truth {
 public:
  explicit Truth(const PhantomOptions& options);
  ~Truth();

  const Geometry& geometry() const { return geometry_; }
  // visible: the vertices of the true skin that the probe sees (phantom.h), voxel indices; 0.5 mm apart.
  const std::vector<glm::vec3>& visible() const { return visible_; }
  // nearVisible: whether a visible vertex lies within `radius` voxels of that index.
  bool nearVisible(const glm::vec3& index, float radius) const;
  // toSkin: signedDistance to the baby's skin.
  double toSkin(const glm::dvec3& world, const glm::dvec3& unit) const;
  // toFluidSurface: voxels to the nearest fluid-tissue surface; kFar where there is none within 8 mm.
  double toFluidSurface(const glm::dvec3& world) const;

 private:
  Geometry geometry_;
  Interface skin_, other_;
  std::vector<glm::vec3> visible_;
  std::unique_ptr<PointTree> tree_;
};

}  // namespace sonoskin::accuracy
