#include "core/face/face_fit.h"

#include <algorithm>
#include <cmath>

#include "core/face/face_search.h"

namespace sonoskin {
namespace {

using glm::vec3;

constexpr float kFirstHeight = 92;  // mm from the chin to the crown of the first head

vec3 middleOf(const SurfacePoints& points) {
  glm::dvec3 sum(0);
  for (const vec3& p : points.positions) sum += glm::dvec3(p);
  return vec3(sum / double(points.size()));
}

// Fitted by hand to 40 simulated heads turned by up to 60 degrees, 48 surfaces without a face, and four real scans.
float confidenceOf(const FaceFit& fit) {
  const FaceEvidence& e = fit.evidence;
  if (e.seen < 0.45f) return 0;
  const float z = 25 * (e.relief - 0.62f) + 16 * (0.62f - fit.rival) + 4 * (std::min(e.gain, 1.f) - 0.65f) +
                  15 * std::min(e.explained - 0.6f, 0.f) + 0.7f;
  return 1 / (1 + std::exp(-z));
}

// Onto the surface, where one is near.
vec3 settled(const vec3& place, const FacePlacement& face, const FaceSpace& space) {
  constexpr float kNear = 3;
  const Surfel* surfel = space.nearest(place);
  if (!surfel || glm::dot(surfel->normal, face.front()) < 0.2f) return place;
  const float before = glm::dot(surfel->place - place, surfel->normal);
  return std::abs(before) < kNear * face.scale ? place + before * surfel->normal : place;
}

}  // namespace

FaceFit fitFace(const FaceInput& input, const FaceOptions& options, const Progress& progress) {
  constexpr std::size_t kEnough = 500;
  FaceFit fit;
  if (input.points.size() < kEnough) return fit;
  const FaceSpace space(input);
  progress.update(0.1);
  const vec3 toProbe(-input.beam.directionAt(glm::dvec3(middleOf(input.points))));
  const SizePrior size{float(options.headHeight) / kFirstHeight};
  const auto found = searchFaces(space, toProbe, size, progress.part(0.1, 1));
  if (found.empty() || found[0].worth <= 0) return fit;
  const FaceHypothesis& best = found[0];
  fit.placement = best.face;
  fit.evidence = best.evidence;
  fit.score = best.score;
  fit.rival = found.size() > 1 ? std::max(found[1].worth, 0.f) / best.worth : 0;
  fit.places = placesOf(fit.placement);
  for (vec3* place : {&fit.places.rightEye, &fit.places.leftEye, &fit.places.noseTip, &fit.places.mouthRight,
                      &fit.places.mouthLeft, &fit.places.chin})
    *place = settled(*place, fit.placement, space);
  fit.up = fit.placement.up();
  fit.front = fit.placement.front();
  fit.headHeight = kFirstHeight * fit.placement.scale;
  fit.confidence = confidenceOf(fit);
  return fit;
}

}  // namespace sonoskin
