#include "tests/benchmarks/accuracy/faces_pose.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sonoskin::accuracy {
namespace {

constexpr double kSure = 0.5, kWrong = 10;  // mm

glm::dmat3 axesOf(const FacePose& pose) { return {glm::cross(pose.up, pose.front), pose.up, pose.front}; }

double turnBetween(const FacePose& a, const FacePose& b) {
  const glm::dmat3 turn = glm::transpose(axesOf(a)) * axesOf(b);
  const double trace = turn[0][0] + turn[1][1] + turn[2][2];
  return glm::degrees(std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)));
}

std::array<glm::dvec3, 5> listOf(const FacePlaces& p) {
  return {p.rightEye, p.leftEye, p.noseTip, p.mouthRight, p.mouthLeft};
}

}  // namespace

void comparePose(const FacePose& found, const FacePose& truth, double confidence, FaceScore& score) {
  const auto ours = listOf(found.places), theirs = listOf(truth.places);
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double apart = glm::distance(ours[i], theirs[i]);
    sum += apart, most = std::max(most, apart);
  }
  score.landmarks = sum / double(ours.size()), score.landmarksMax = most;
  score.pose = turnBetween(found, truth);
  score.confidence = confidence;
  score.misled = confidence >= kSure && score.landmarks > kWrong ? 1 : 0;
}

}  // namespace sonoskin::accuracy
