#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/skin/diffusion_target.h"
#include "core/skin/radial_profile.h"
#include "core/skin/surface_samples.h"

namespace sonoskin {

// IntegralOptions: how light is gathered from a tree.
//   eps          a node whose area is below eps times its squared distance counts as one sample; 0: never
//   normalised   divided by the integral of the profile over the local surface, which a plane makes 1: takes away the
//                unevenness of the samples and the dark rim where a surface ends
struct IntegralOptions {
  double eps = 0.05;
  Reach reach = Reach::full;
  bool normalised = true;
};

// HierarchicalIntegral: integrates light with any profile over a surface, near samples one by one and far ones in clusters.
//   method    an octree; a node holds its area, its power and where that is            [Jensen, Buhler 2002]
//   cost      to build: 600,000 samples, 0.2 s; a target: 0.04 ms (eps 0.05)
//   threads   at() may be called from several
class HierarchicalIntegral {
 public:
  // irradiance   per sample
  // errors       Error: no samples, not one irradiance per sample
  HierarchicalIntegral(const SurfaceSamples& samples, std::span<const glm::vec3> irradiance);

  // at: sum_j A_j R(|x - x_j|) E_j, if normalised divided by sum_j A_j R(|x - x_j|) / total over local samples.
  glm::vec3 at(const glm::vec3& position, const glm::vec3& normal, const RadialProfile& profile,
               const IntegralOptions& options) const;

 private:
  struct Source {  // a sample, or a node as one
    glm::vec3 position, normal, power, powerPosition;
    float area = 0;
  };
  struct Node {
    Source source;
    std::uint32_t first = 0, count = 0;  // of its samples; count 0: not a leaf
    std::uint32_t next = 0;              // node after this one and all below it
  };
  struct Accumulator;

  Source merged(std::uint32_t first, std::uint32_t last) const;
  void build(std::uint32_t first, std::uint32_t last, int level, std::span<const std::uint64_t> codes);

  std::vector<Source> samples_;  // in the order of the tree
  std::vector<Node> nodes_;      // children follow their parent
};

}  // namespace sonoskin
