#include "tests/benchmarks/accuracy/faces_score.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/parallel.h"
#include "core/mesh/half_edges.h"
#include "tests/benchmarks/accuracy/faces_spurs.h"
#include "tests/benchmarks/accuracy/skin_places.h"

namespace sonoskin::accuracy {
namespace {

constexpr float kForeign = 3, kBorder = 3, kCovered = 1, kMissed = 2;  // mm
constexpr float kMissedAngle = 90;                                     // degrees
constexpr std::ptrdiff_t kBatch = 512;

template <class Body>
void forEachBatch(std::size_t count, const Body& body) {
  const auto total = std::ptrdiff_t(count);
  parallelFor((total + kBatch - 1) / kBatch, [&](std::ptrdiff_t batch) {
    body(std::size_t(batch * kBatch), std::size_t(std::min(total, (batch + 1) * kBatch)));
  });
}

// What is known of a place of the mesh.
struct MeshPlace {
  FaceTruth::Foot foot;
  bool facesAlike = true;  // the mesh's normal and the truth's
  bool isNearBorder = false, isTissue = false;

  bool isForeign() const { return std::abs(foot.distance) > kForeign; }
};

// The open border as triangles without area, one for each edge, for distances to it.
Mesh borderOf(const Mesh& mesh) {
  Mesh border;
  border.positions = mesh.positions;
  const std::vector<std::uint32_t> opposite = oppositeHalfEdges(mesh.triangles, mesh.positions.size());
  for (std::uint32_t h = 0; h < opposite.size(); ++h) {
    if (opposite[h] != kNoHalfEdge) continue;
    const std::uint32_t to = originOf(mesh.triangles, nextHalfEdge(h));
    border.triangles.push_back({originOf(mesh.triangles, h), to, to});
  }
  return border;
}

std::vector<MeshPlace> measurePlaces(const Mesh& mesh, const FaceTruth& truth) {
  const SkinPlaces places = spreadPlaces(mesh, placesFor(mesh));
  std::vector<MeshPlace> result(places.positions.size());
  const Mesh border = borderOf(mesh);
  std::optional<TriangleTree> toBorder;
  if (!border.empty()) toBorder.emplace(border);
  forEachBatch(result.size(), [&](std::size_t from, std::size_t to) {
    std::uint32_t guess = 0;
    for (std::size_t i = from; i < to; ++i) {
      result[i].foot = truth.foot(places.positions[i], guess);
      result[i].facesAlike = glm::dot(result[i].foot.normal, places.normals[i]) > 0;
      result[i].isTissue = result[i].isForeign() && truth.isOtherTissue(places.positions[i]);
      result[i].isNearBorder = toBorder && toBorder->nearestWithin(places.positions[i], kBorder).has_value();
    }
  });
  return result;
}

// Distances collected for a root mean square, a quantile and a maximum.
class Distances {
 public:
  void add(float signedDistance) { values_.push_back(signedDistance); }

  double rms() const {
    double squares = 0;
    for (const float d : values_) squares += double(d) * double(d);
    return values_.empty() ? kUnknown : std::sqrt(squares / double(values_.size()));
  }
  double median() const { return quantile(values_, 0.5); }
  double p95() const { return quantile(absolute(), 0.95); }
  double max() const { return quantile(absolute(), 1); }

 private:
  std::vector<float> absolute() const {
    std::vector<float> result;
    for (const float d : values_) result.push_back(std::abs(d));
    return result;
  }
  static double quantile(std::vector<float> of, double share) {
    if (of.empty()) return kUnknown;
    const auto at = of.begin() + std::ptrdiff_t(share * double(of.size() - 1) + 0.5);
    std::nth_element(of.begin(), at, of.end());
    return double(*at);
  }

  std::vector<float> values_;
};

void scoreDistances(const std::vector<MeshPlace>& places, FaceScore& score) {
  Distances own, border, interior, all, allBorder;
  double foreign = 0, tissue = 0;
  for (const MeshPlace& place : places) {
    if (place.isForeign()) ++foreign;
    if (place.isTissue) ++tissue;
    if (!place.foot.isVisible) continue;
    all.add(place.foot.distance);
    if (place.isNearBorder) allBorder.add(place.foot.distance);
    if (place.isForeign()) continue;
    own.add(place.foot.distance);
    (place.isNearBorder ? border : interior).add(place.foot.distance);
  }
  score.rms = own.rms(), score.p95 = own.p95(), score.max = own.max(), score.offset = own.median();
  score.border = border.rms(), score.interior = interior.rms();
  score.rmsAll = all.rms(), score.maxAll = all.max(), score.borderAll = allBorder.rms();
  if (places.empty()) return;
  score.foreign = foreign / double(places.size()), score.tissue = tissue / double(places.size());
}

// Whether the mesh as a whole is turned outside in.
bool isInsideOut(const std::vector<MeshPlace>& places) {
  std::ptrdiff_t alike = 0;
  for (const MeshPlace& place : places)
    if (place.foot.isVisible && !place.isForeign()) alike += place.facesAlike ? 1 : -1;
  return alike < 0;
}

// What is known of a place of the truth: the mesh's nearest place.
struct Partner {
  float distance = std::numeric_limits<float>::infinity();
  float angle = kMissedAngle;  // between the normals, degrees
};

std::vector<Partner> findPartners(const Mesh& mesh, const FaceTruth& truth, bool insideOut) {
  const std::vector<TruthPlace>& places = truth.visible();
  const TriangleTree tree(mesh);
  std::vector<Partner> result(places.size());
  forEachBatch(result.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const auto hit = tree.nearestWithin(places[i].position, kMissed);
      if (!hit) continue;
      const Triangle& t = mesh.triangles[hit->triangle];
      const glm::vec3& w = hit->place.weights;
      const glm::vec3 normal = w.x * mesh.normals[t[0]] + w.y * mesh.normals[t[1]] + w.z * mesh.normals[t[2]];
      const float length = insideOut ? -glm::length(normal) : glm::length(normal);
      if (length == 0) continue;  // a fold without a direction shows nothing
      const float cosine = std::clamp(glm::dot(normal, places[i].normal) / length, -1.f, 1.f);
      result[i] = {std::sqrt(hit->squaredDistance), glm::degrees(std::acos(cosine))};
    }
  });
  return result;
}

// A mean that is unknown without values.
struct Mean {
  double sum = 0, count = 0;
  void add(double value) { sum += value, ++count; }
  double value() const { return count > 0 ? sum / count : kUnknown; }
};

void scoreCoverage(const std::vector<Partner>& partners, const FaceTruth& truth, FaceScore& score) {
  Mean all;
  std::array<Mean, 5> parts;  // by BodyPart
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const double found = partners[i].distance < kCovered ? 1 : 0;
    all.add(found);
    parts[std::size_t(truth.visible()[i].part)].add(found);
  }
  score.covered = all.value();
  const auto of = [&](BodyPart part) { return parts[std::size_t(part)].value(); };
  score.coveredFace = of(BodyPart::face), score.coveredHead = of(BodyPart::head);
  score.coveredHand = of(BodyPart::hand), score.coveredBody = of(BodyPart::body);
}

void scoreDetail(const std::vector<Partner>& partners, const FaceTruth& truth, FaceScore& score) {
  const FeaturePlaces& features = truth.features();
  Mean eyes, nose, mouth, all;
  for (std::size_t i = 0; i < partners.size(); ++i) {
    const auto isIn = [&](const Feature& f) {
      return glm::distance(truth.visible()[i].position, f.centre) < f.radius;
    };
    const bool inEyes = isIn(features.eyes[0]) || isIn(features.eyes[1]);
    const bool inNose = isIn(features.nose), inMouth = isIn(features.mouth);
    const auto angle = double(partners[i].angle);
    if (inEyes) eyes.add(angle);
    if (inNose) nose.add(angle);
    if (inMouth) mouth.add(angle);
    if (inEyes || inNose || inMouth) all.add(angle);
  }
  score.eyes = eyes.value(), score.nose = nose.value(), score.mouth = mouth.value();
  score.detail = all.value();
}

void scoreSpurs(const Spurs& spurs, FaceScore& score) {
  score.spurs = double(spurs.count), score.spurArea = spurs.area;
  score.spurless = spurs.count == 0 ? 1 : 0;
  if (spurs.count == 0) return;
  const glm::dvec3 at(spurs.largest);
  score.spurX = at.x, score.spurY = at.y, score.spurZ = at.z;
}

}  // namespace

FaceScore scoreFace(const Mesh& mesh, const FaceTruth& truth) {
  FaceScore score;
  if (mesh.empty()) return score;
  if (mesh.normals.empty()) {
    Mesh copy = mesh;
    computeNormals(copy);
    return scoreFace(copy, truth);
  }
  const std::vector<MeshPlace> places = measurePlaces(mesh, truth);
  scoreDistances(places, score);
  const std::vector<Partner> partners = findPartners(mesh, truth, isInsideOut(places));
  scoreCoverage(partners, truth, score);
  scoreDetail(partners, truth, score);
  scoreSpurs(findSpurs(mesh, truth), score);
  score.triangles = double(mesh.triangles.size()), score.area = surfaceArea(mesh);
  return score;
}

}  // namespace sonoskin::accuracy
