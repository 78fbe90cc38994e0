#pragma once

#include <memory>

#include "core/skin/skin_surface.h"
#include "tests/benchmarks/accuracy/skin_places.h"

namespace sonoskin::accuracy {

// LitAtlas: a head's light in its atlas after it has spread.
struct LitAtlas {
  std::shared_ptr<const SkinSurface> surface;
  std::vector<glm::vec4> diffused;  // all Gaussians of the literature but the narrowest

  // at: the sum of all six terms at a place where `irradiance` falls.
  glm::vec3 at(const SkinPlace& place, const glm::vec3& irradiance) const;
};

// litByPasses: by the blurs of SkinView; needs a current context.
LitAtlas litByPasses(std::shared_ptr<const SkinSurface> surface, const SkinLighting& lighting);

// litByPoints: from point to point; says on standard error how long it took.
LitAtlas litByPoints(std::shared_ptr<const SkinSurface> surface, const SkinLighting& lighting);

}  // namespace sonoskin::accuracy
