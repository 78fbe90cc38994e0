#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "core/phantom/fetal_arm.h"
#include "core/phantom/scene_plan.h"

namespace sonoskin {

// SkinFunction: signed distance to skin in the head's frame.
using SkinFunction = std::function<float(const glm::vec3&)>;

// skinToward: where the skin is met first, coming from outside, on the line from `middle` along `direction`.
glm::vec3 skinToward(const SkinFunction& skin, const glm::vec3& middle, const glm::vec3& direction);

// slopeOf: the gradient of a signed distance.
glm::vec3 slopeOf(const SkinFunction& skin, const glm::vec3& p);

// scaledArm: an arm and all places of it times `size`.
Arm scaledArm(const Arm& arm, float size);

// withdrawHand: moves a hand along `direction` until its flesh is pressed 0.8 mm into the skin at most and in
// one place at least; the elbow stays.
void withdrawHand(Arm& arm, const SkinFunction& skin, const glm::vec3& direction);

// reachFor: an arm like `arm` (a left one), its hand laid flat on the skin at a place.
//   shoulder  where it begins; for a right hand the right one
//   method    the elbow where the lengths of upper arm and forearm meet, outward and down of the straight line;
//             both longer where they do not reach
Arm reachFor(const Arm& arm, const HandPlace& place, const SkinFunction& skin, const glm::vec3& shoulder);

}  // namespace sonoskin
