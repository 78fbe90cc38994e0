#include "core/pipeline/phantom_landmarks.h"

#include <cmath>

#include "core/phantom/phantom_model.h"

namespace sonoskin {
namespace {

std::array<double, 3> rounded(const glm::dvec3& p) {
  const auto tenths = [](double mm) { return std::round(10 * mm) / 10; };
  return {tenths(p.x), tenths(p.y), tenths(p.z)};
}

}  // namespace

LandmarkOptions phantomLandmarks(const PhantomOptions& options) {
  const FacePlaces places = PhantomModel(options).facePlaces();
  return {rounded(places.rightEye), rounded(places.leftEye), rounded(places.noseTip),
          rounded(places.mouthRight), rounded(places.mouthLeft)};
}

bool hasLandmarks(const LandmarkOptions& landmarks) { return !(landmarks == LandmarkOptions{}); }

}  // namespace sonoskin
