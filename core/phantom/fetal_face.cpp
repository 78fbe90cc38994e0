#include "core/phantom/fetal_face.h"

#include "core/phantom/phantom_model.h"

namespace sonoskin {
namespace {

const PhantomModel& first() {
  static const PhantomModel kModel{PhantomOptions{}};
  return kModel;
}

}  // namespace

double skinDistance(const glm::dvec3& world) { return first().skin(world); }

FacePlaces facePlaces() { return first().facePlaces(); }

double boneDistance(const glm::dvec3& world) { return first().bone(world); }

double wallDistance(const glm::dvec3& world) { return first().wall(world); }

}  // namespace sonoskin
