#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/phantom/head_pose.h"
#include "core/phantom/phantom_options.h"

namespace sonoskin {

// HandPlace: where a hand lies.
//   knuckles   the direction from the middle of the head to the skin under the knuckles; head's frame
//   fingers    the direction in which the fingers point; head's frame
//   right      whether it is the right hand
struct HandPlace {
  glm::vec3 knuckles, fingers;
  bool right = false;
};

// ScenePlan: what a scene puts where. Without a place in `hands` a hand lies beside the mouth, as in `clear`.
//   trunkTurn   how the trunk lies beside the head
//   lobes       directions from the middle of the head (its frame) to skin that placenta or wall touches
//   wallBack    mm that the front wall lies nearer to the probe, so that the volume begins behind it
//   membranes   how many strands and sheets stand between face and wall
//   cordSide    -1, 1: the cord lies over the right or left cheek; 0: no cord
struct ScenePlan {
  HeadTurn turn;
  glm::vec3 centre{57, 71, 56};
  HeadTurn trunkTurn{0, 0, 0};
  std::vector<HandPlace> hands;
  std::vector<glm::vec3> lobes;
  float wallBack = 0;
  int membranes = 0;
  int cordSide = 0;
};

// planScene: draws the plan of a scene from its seed and shape; the poses of clear, thick, haze, saturated,
// enhanced and planes are the same for all seeds.
//   turned     yaw 25 to 60 degrees to either side, pitch -8 to 12, roll -22 to 22
//   attached, cord, hands   yaw -12 to 12 degrees, pitch -5 to 7, roll -10 to 10
//   clinical   yaw 8 to 35 degrees to either side, pitch -8 to 12, roll -15 to 15
//   hands      seed modulo 6: at the temple, before the chin, over an eye, both at the cheeks, both before the
//              mouth, at the forehead; of the left or right side by chance
ScenePlan planScene(const PhantomOptions& options);

}  // namespace sonoskin
