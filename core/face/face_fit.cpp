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

// How good a hypothesis is once its relief is known.
float worth(const FaceHypothesis& h, const FaceEvidence& e) {
  return h.score * (0.3f + std::max(e.relief, 0.f));
}

float confidenceOf(const FaceFit& fit) {
  const FaceEvidence& e = fit.evidence;
  const float z =
      9 * (e.relief - 0.45f) + 4 * (e.explained - 0.55f) - 10 * e.against - 2 * (fit.rival - 0.6f);
  return e.seen > 0 ? 1 / (1 + std::exp(-z)) : 0;
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
  float best = -1, second = 0;
  for (const FaceHypothesis& h : found) {
    const FaceEvidence evidence = faceEvidence(h.face, space);
    const float here = worth(h, evidence);
    if (here <= best) {
      second = std::max(second, here);
      continue;
    }
    second = std::max(best, 0.f);
    best = here;
    fit.placement = h.face;
    fit.evidence = evidence;
    fit.score = h.score;
  }
  if (best <= 0) return fit;
  fit.rival = second / best;
  fit.places = placesOf(fit.placement);
  fit.up = fit.placement.up();
  fit.front = fit.placement.front();
  fit.headHeight = kFirstHeight * fit.placement.scale;
  fit.confidence = confidenceOf(fit);
  return fit;
}

}  // namespace sonoskin
