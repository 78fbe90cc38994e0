#include "core/pipeline/face_use.h"

#include <fmt/format.h>

#include <cmath>

namespace sonoskin {
namespace {

// Heads from the twentieth week to some weeks after birth, from the chin to the crown.
constexpr float kLeastHead = 55, kMostHead = 125;

std::array<double, 3> tenths(const glm::vec3& p) {
  const auto rounded = [](float mm) { return std::round(10 * double(mm)) / 10; };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

}  // namespace

bool isCertain(const FaceFit* face, const FaceOptions& options) {
  return face && face->confidence > 0 && double(face->confidence) >= options.confidence;
}

LandmarkOptions landmarksWithFace(const Parameters& parameters, const FaceFit* face) {
  LandmarkOptions landmarks = parameters.landmarks;
  if (!isCertain(face, parameters.face)) return landmarks;
  const auto fill = [](std::array<double, 3>& landmark, const glm::vec3& found) {
    if (!isSet(landmark)) landmark = tenths(found);
  };
  fill(landmarks.rightEye, face->places.rightEye);
  fill(landmarks.leftEye, face->places.leftEye);
  fill(landmarks.noseTip, face->places.noseTip);
  fill(landmarks.mouthRight, face->places.mouthRight);
  fill(landmarks.mouthLeft, face->places.mouthLeft);
  return landmarks;
}

std::optional<FaceSite> siteOf(const FaceFit* face, const FaceOptions& options) {
  if (!isCertain(face, options)) return {};
  FaceSite site{{}, {}, face->placement.at, face->up, face->front, face->headHeight};
  for (const FacePoint& point : faceModel().points) {
    site.places.push_back(face->placement.toWorld(face->placement.inHead(point)));
    site.normals.push_back(face->placement.normal(point));
  }
  return site;
}

std::string faceText(const FaceFit* face, const FaceOptions& options) {
  if (!face) return {};
  if (!isCertain(face, options))
    return fmt::format("no face is certain enough to be used (confidence {:.2f} of {:.2f})", face->confidence,
                       options.confidence);
  return fmt::format("a face was found, its head about {:.0f} mm from chin to crown (confidence {:.2f})",
                     face->headHeight, face->confidence);
}

std::string scaleWarning(const FaceFit* face, const FaceOptions& options) {
  if (!isCertain(face, options)) return {};
  if (face->headHeight >= kLeastHead && face->headHeight <= kMostHead) return {};
  return fmt::format(
      "the head would be {:.0f} mm from chin to crown, where heads before and after birth have {:.0f} to "
      "{:.0f}: is "
      "the spacing right?",
      face->headHeight, kLeastHead, kMostHead);
}

}  // namespace sonoskin
