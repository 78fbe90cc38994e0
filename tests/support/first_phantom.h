#pragma once

#include "core/phantom/phantom_model.h"

namespace sonoskin::test {

// firstPhantom: the phantom of the default options.
inline const PhantomModel& firstPhantom() {
  static const PhantomModel kModel{PhantomOptions{}};
  return kModel;
}

// skinDistance, boneDistance, wallDistance: signed distances to its surfaces, mm; negative inside.
inline double skinDistance(const glm::dvec3& world) { return firstPhantom().skin(world); }
inline double boneDistance(const glm::dvec3& world) { return firstPhantom().bone(world); }
inline double wallDistance(const glm::dvec3& world) { return firstPhantom().wall(world); }

}  // namespace sonoskin::test
