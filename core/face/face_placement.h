#pragma once

#include <glm/glm.hpp>

#include "core/face/face_model.h"

namespace sonoskin {

// FacePlacement: a face of the model in the world: at + scale * turn * (place, moved along its modes); mm.
struct FacePlacement {
  glm::mat3 turn{1};  // a rotation: columns are the baby's left, up and forward
  glm::vec3 at{0};    // the head's origin, between the ears
  float scale = 1;
  FaceModes modes{};

  glm::vec3 inHead(const FacePoint& point) const {
    float along = 0;
    for (int m = 0; m < kFaceModes; ++m) along += modes[std::size_t(m)] * point.along[std::size_t(m)];
    return point.place + along * point.normal;
  }
  glm::vec3 toWorld(const glm::vec3& head) const { return at + scale * (turn * head); }
  glm::vec3 normal(const FacePoint& point) const { return turn * point.normal; }
  glm::vec3 up() const { return turn[1]; }
  glm::vec3 front() const { return turn[2]; }
};

// placesOf: the landmarks of a placed face, world mm.
HeadPlaces placesOf(const FacePlacement& face);

}  // namespace sonoskin
