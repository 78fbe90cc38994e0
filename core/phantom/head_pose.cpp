#include "core/phantom/head_pose.h"

#include <cmath>

namespace sonoskin {

glm::dmat3 turnAbout(const HeadTurn& t) {
  const glm::dmat3 turn{
      {std::cos(t.yaw), 0, -std::sin(t.yaw)}, {0, 1, 0}, {std::sin(t.yaw), 0, std::cos(t.yaw)}};
  const glm::dmat3 bow{
      {1, 0, 0}, {0, std::cos(t.pitch), std::sin(t.pitch)}, {0, -std::sin(t.pitch), std::cos(t.pitch)}};
  const glm::dmat3 tilt{
      {std::cos(t.roll), std::sin(t.roll), 0}, {-std::sin(t.roll), std::cos(t.roll), 0}, {0, 0, 1}};
  return bow * turn * tilt;
}

HeadPose headPose(const HeadTurn& turn, const glm::vec3& centre) {
  const glm::dmat3 axes{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};  // columns: where world x, y, z point in the head
  return {centre, glm::mat3(turnAbout(turn) * axes)};
}

}  // namespace sonoskin
