#include "core/face/face_score.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

using glm::vec3;

constexpr float kAgrees = 0.4f;  // cosine of normals from which they begin to agree
constexpr float kFreeCost = 0.7f, kDarkCost = 0.15f;

float agreement(const Surfel& surfel, const vec3& normal) {
  return std::clamp((glm::dot(surfel.normal, normal) - kAgrees) / (0.9f - kAgrees), 0.f, 1.f);
}

HeadPlaces mapped(const HeadPlaces& places, const auto& f) {
  return {f(places.rightEye), f(places.leftEye), f(places.noseTip),
          f(places.mouthRight), f(places.mouthLeft), f(places.chin)};
}

}  // namespace

HeadPlaces placesOf(const FacePlacement& face) {
  const FaceModel& model = faceModel();
  HeadPlaces places = model.places;
  for (int m = 0; m < kFaceModes; ++m) {
    const HeadPlaces& moves = model.moves[std::size_t(m)];
    const float by = face.modes[std::size_t(m)];
    places.rightEye += by * moves.rightEye;
    places.leftEye += by * moves.leftEye;
    places.noseTip += by * moves.noseTip;
    places.mouthRight += by * moves.mouthRight;
    places.mouthLeft += by * moves.mouthLeft;
    places.chin += by * moves.chin;
  }
  return mapped(places, [&](const vec3& p) { return face.toWorld(p); });
}

float faceScore(const FacePlacement& face, const FaceSpace& space, std::size_t points, float width) {
  const FaceModel& model = faceModel();
  const std::size_t count = std::min(points, model.points.size());
  float sum = 0, weights = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const FacePoint& point = model.points[i];
    const vec3 place = face.toWorld(face.inHead(point));
    weights += point.weight;
    if (const Surfel* surfel = space.nearest(place)) {
      const float off = glm::dot(place - surfel->place, surfel->normal) / width;
      const float fits = agreement(*surfel, face.normal(point)) * std::exp2(-off * off);
      if (fits > 0.1f) {
        sum += point.weight * fits;
        continue;
      }
    }
    const FaceSpace::Kind kind = space.kind(place);
    if (kind == FaceSpace::Kind::free) sum -= kFreeCost * point.weight;
    if (kind == FaceSpace::Kind::dark) sum -= kDarkCost * point.weight;
  }
  return sum / weights * face.scale * face.scale;
}

namespace {

// How far the surface lies before a model's point, along its normal; and whether there is one.
struct Offset {
  float before = 0;
  bool there = false;
};

Offset offsetAt(const vec3& place, const vec3& normal, const FaceSpace& space, float reach) {
  const Surfel* surfel = space.nearest(place);
  if (!surfel) return {};
  const float along = glm::dot(surfel->normal, normal);
  if (along < 0.25f) return {};
  const float before = glm::dot(surfel->place - place, surfel->normal) / std::max(along, 0.5f);
  return {before, std::abs(before) < reach};
}

// The correlation of two reliefs over the inner face, and the gain from one to the other.
void compareRelief(const std::vector<Offset>& offsets, FaceEvidence& evidence, float scale) {
  const FaceModel& model = faceModel();
  double n = 0, all = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (const FaceModel::Inner& inner : model.inner) {
    const double weight = double(model.points[inner.point].weight);
    all += weight;
    if (!offsets[inner.point].there) continue;
    float mean = 0, shares = 0;
    for (const FaceNeighbour& neighbour : inner.around) {
      if (!offsets[neighbour.point].there) continue;
      mean += neighbour.share * offsets[neighbour.point].before;
      shares += neighbour.share;
    }
    const double expected = double(scale * model.points[inner.point].relief);
    const double found = expected + double(offsets[inner.point].before - mean / shares);
    n += weight;
    a += weight * expected;
    b += weight * found;
    aa += weight * expected * expected;
    bb += weight * found * found;
    ab += weight * expected * found;
  }
  if (n < 0.2 * all) return;
  const double va = aa / n - a * a / (n * n), vb = bb / n - b * b / (n * n), vab = ab / n - a * b / (n * n);
  evidence.seen = float(n / all);
  evidence.relief = float(vab / std::sqrt(std::max(va * vb, 1e-12)));
  evidence.gain = float(vab / std::max(va, 1e-12));
}

}  // namespace

FaceEvidence faceEvidence(const FacePlacement& face, const FaceSpace& space) {
  const FaceModel& model = faceModel();
  const float reach = 8 * face.scale, near = 2.5f * face.scale;
  FaceEvidence evidence;
  std::vector<Offset> offsets(model.points.size());
  double explained = 0, against = 0, squares = 0;
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    const FacePoint& point = model.points[i];
    const vec3 place = face.toWorld(face.inHead(point));
    const double weight = double(point.weight);
    offsets[i] = offsetAt(place, face.normal(point), space, reach);
    if (offsets[i].there && std::abs(offsets[i].before) < near) {
      explained += weight;
      squares += weight * double(offsets[i].before * offsets[i].before);
    } else if (space.kind(place) == FaceSpace::Kind::free) {
      against += weight;
    }
  }
  evidence.explained = float(explained);
  evidence.against = float(against);
  evidence.residual = float(std::sqrt(squares / std::max(explained, 1e-9)));
  compareRelief(offsets, evidence, face.scale);
  return evidence;
}

}  // namespace sonoskin
