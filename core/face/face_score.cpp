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

// How well a surface fits that is so many widths off, squared: 1 at 0, a half at 1.
float fitAt(float square) {
  const float inner = 1 + 0.41421356f * square;
  return 1 / (inner * inner);
}

HeadPlaces mapped(const HeadPlaces& places, const auto& f) {
  return {f(places.rightEye),   f(places.leftEye),   f(places.noseTip),
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
  constexpr std::size_t kLook = 32;  // after so many points hopeless faces are given up
  constexpr float kHopeless = 0.2f;
  const FaceModel& model = faceModel();
  const std::size_t count = std::min(points, model.points.size());
  const bool plain = face.modes == FaceModes{};
  const float inverse = 1 / width;
  float sum = 0, weights = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i == kLook && sum < kHopeless * weights) break;
    const FacePoint& point = model.points[i];
    const vec3 place = face.toWorld(plain ? point.place : face.inHead(point));
    weights += point.weight;
    if (const Surfel* surfel = space.nearest(place)) {
      const float off = glm::dot(place - surfel->place, surfel->normal) * inverse;
      const float fits = agreement(*surfel, face.normal(point)) * fitAt(off * off);
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

// Correspondence: a point of the model in the world, and the place of the surface nearest to it, if there is one.
struct Correspondence {
  vec3 place, found, normal;  // `normal` of what was found
  float before = 0;           // mm that the surface lies before the point
  bool exists = false;
};

Correspondence correspondenceOf(const FacePoint& point, const FacePlacement& face, const FaceSpace& space,
                                float reach) {
  Correspondence m;
  m.place = face.toWorld(face.inHead(point));
  const Surfel* surfel = space.nearest(m.place);
  if (!surfel || glm::dot(surfel->normal, face.normal(point)) < 0.25f) return m;
  m.before = glm::dot(surfel->place - m.place, surfel->normal);
  m.normal = surfel->normal;
  m.found = m.place + m.before * m.normal;
  m.exists = std::abs(m.before) < reach;
  return m;
}

// Relief: how high a point of the model stands over the mean of those around it that have a surface; and how high
// that surface does.
struct Relief {
  double expected = 0, found = 0;
};

Relief reliefAt(const FaceModel::Inner& inner, const FacePlacement& face,
                const std::vector<Correspondence>& correspondences) {
  vec3 place(0), found(0), up(0), foundUp(0);
  float shares = 0;
  for (const FaceNeighbour& neighbour : inner.around) {
    const Correspondence& there = correspondences[neighbour.point];
    if (!there.exists) continue;
    place += neighbour.share * there.place;
    found += neighbour.share * there.found;
    up += neighbour.share * face.normal(faceModel().points[neighbour.point]);
    foundUp += neighbour.share * there.normal;
    shares += neighbour.share;
  }
  const Correspondence& here = correspondences[inner.point];
  return {double(glm::dot(here.place - place / shares, glm::normalize(up))),
          double(glm::dot(here.found - found / shares, glm::normalize(foundUp)))};
}

// The correlation of two reliefs over the inner face, and the gain from one to the other.
void compareRelief(const std::vector<Correspondence>& correspondences, const FacePlacement& face,
                   FaceEvidence& evidence) {
  const FaceModel& model = faceModel();
  double n = 0, all = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (const FaceModel::Inner& inner : model.inner) {
    const double weight = double(model.points[inner.point].weight);
    all += weight;
    if (!correspondences[inner.point].exists) continue;
    const Relief relief = reliefAt(inner, face, correspondences);
    n += weight;
    a += weight * relief.expected;
    b += weight * relief.found;
    aa += weight * relief.expected * relief.expected;
    bb += weight * relief.found * relief.found;
    ab += weight * relief.expected * relief.found;
  }
  if (n < 0.2 * all) return;
  constexpr double kNoise = 0.1;  // mm², so that the noise of a smooth surface is like nothing
  const double va = aa / n - a * a / (n * n), vb = bb / n - b * b / (n * n), vab = ab / n - a * b / (n * n);
  evidence.seen = float(n / all);
  evidence.relief = float(vab / std::sqrt(va * (vb + kNoise) + 1e-12));
  evidence.gain = float(vab / std::max(va, 1e-12));
}

}  // namespace

FaceEvidence faceEvidence(const FacePlacement& face, const FaceSpace& space) {
  const FaceModel& model = faceModel();
  const float reach = 8 * face.scale, near = 2.5f * face.scale;
  FaceEvidence evidence;
  std::vector<Correspondence> correspondences(model.points.size());
  double explained = 0, against = 0, squares = 0;
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    const double weight = double(model.points[i].weight);
    const Correspondence correspondence = correspondences[i] =
        correspondenceOf(model.points[i], face, space, reach);
    if (correspondence.exists && std::abs(correspondence.before) < near) {
      explained += weight;
      squares += weight * double(correspondence.before * correspondence.before);
    } else if (space.kind(correspondence.place) == FaceSpace::Kind::free) {
      against += weight;
    }
  }
  evidence.explained = float(explained);
  evidence.against = float(against);
  evidence.residual = float(std::sqrt(squares / std::max(explained, 1e-9)));
  compareRelief(correspondences, face, evidence);
  return evidence;
}

}  // namespace sonoskin
