#include "tests/benchmarks/accuracy/faces_truth.h"

#include <cmath>
#include <memory>

#include "core/phantom/phantom_model.h"
#include "tests/benchmarks/accuracy/skin_places.h"

namespace sonoskin::accuracy {
namespace {

constexpr float kVisible = 0.5f;
constexpr double kOther = 2;  // mm

template <class T>
T mix(const std::vector<T>& of, const Triangle& t, const glm::vec3& w) {
  return w.x * of[t[0]] + w.y * of[t[1]] + w.z * of[t[2]];
}

BodyPart partAt(const Mesh& mesh, const Triangle& t, const glm::vec3& w) {
  if (mesh.labels.empty()) return BodyPart::other;
  const int nearest = w.x >= w.y && w.x >= w.z ? 0 : (w.y >= w.z ? 1 : 2);
  return BodyPart(mesh.labels[t[std::size_t(nearest)]]);
}

}  // namespace

FaceTruth::FaceTruth(Mesh skin, FaceAnatomy anatomy)
    : skin_(std::move(skin)), anatomy_(std::move(anatomy)), tree_(skin_) {
  if (skin_.normals.empty()) computeNormals(skin_);
  spreadVisible();
}

void FaceTruth::spreadVisible() {
  const SkinPlaces all = spreadPlaces(skin_, placesFor(skin_));
  for (std::size_t i = 0; i < all.places.size(); ++i) {
    const Triangle& t = skin_.triangles[all.places[i].triangle];
    const glm::vec3& w = all.places[i].weights;
    if (!skin_.visibility.empty() && mix(skin_.visibility, t, w) < kVisible) continue;
    visible_.push_back({all.positions[i], all.normals[i], partAt(skin_, t, w)});
  }
}

FaceTruth::Foot FaceTruth::foot(const glm::vec3& query, std::uint32_t& guess) const {
  const TriangleTree::Hit hit = tree_.nearest(query, guess);
  guess = hit.triangle;
  const Triangle& t = skin_.triangles[hit.triangle];
  Foot foot;
  foot.normal = glm::normalize(mix(skin_.normals, t, hit.place.weights));
  foot.distance = std::copysign(std::sqrt(hit.squaredDistance),
                                glm::dot(query - hit.place.position, foot.normal) < 0 ? -1.f : 1.f);
  foot.isVisible = skin_.visibility.empty() || mix(skin_.visibility, t, hit.place.weights) >= kVisible;
  return foot;
}

float FaceTruth::distanceUpTo(const glm::vec3& query, float limit) const {
  const auto hit = tree_.nearestWithin(query, limit);
  return hit ? std::sqrt(hit->squaredDistance) : limit;
}

bool FaceTruth::isOtherTissue(const glm::vec3& query) const {
  return anatomy_.other && anatomy_.other(glm::dvec3(query)) < kOther;
}

FaceAnatomy phantomAnatomy(const PhantomOptions& options) {
  const auto model = std::make_shared<const PhantomModel>(options);
  const FacePlaces places = model->facePlaces();
  const float apart = float(glm::distance(places.rightEye, places.leftEye));
  const FeaturePlaces features{
      {Feature{places.rightEye, 0.25f * apart}, Feature{places.leftEye, 0.25f * apart}},
      {places.noseTip, 0.3f * apart},
      {0.5 * (places.mouthRight + places.mouthLeft), 0.4f * apart}};
  const glm::mat3& toHead = model->head().worldToHead;  // its rows are the head's axes in the world
  const FacePose pose{places, glm::transpose(toHead)[1], glm::transpose(toHead)[2]};
  return {features, [model](const glm::dvec3& p) { return model->other(p); }, pose};
}

}  // namespace sonoskin::accuracy
