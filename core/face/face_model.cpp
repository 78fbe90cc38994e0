#include "core/face/face_model.h"

#include <Eigen/Dense>
#include <cmath>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

using glm::vec3;

constexpr int kPoints = 900;
constexpr float kBesideWeight = 0.35f;  // of forehead and cheeks, which every ball has too

// The point of a direction from within the head, if it is one of the face.
bool placeAlong(const vec3& direction, FacePoint& point) {
  const vec3 from(0, 4, 0);
  const HeadShape mean;
  float far = 75;
  for (int step = 0; step < 60; ++step) {
    const float d = headSkin(from + far * direction, mean);
    far -= 0.9f * d;
    if (d < 1e-3f) break;
  }
  point.place = from + far * direction;
  constexpr float kStep = 0.05f;
  for (int axis = 0; axis < 3; ++axis) {
    vec3 h(0);
    h[axis] = kStep;
    point.normal[axis] = headSkin(point.place + h, mean) - headSkin(point.place - h, mean);
  }
  point.normal = glm::normalize(point.normal);
  const float slant = std::max(glm::dot(point.normal, direction), 0.2f);
  point.weight = far * far / slant;
  const vec3& p = point.place;
  return p.z > 2 && p.y > -42 && std::abs(p.x) < 35 && p.y - 0.4f * p.z < 45;
}

// Points whose every prefix is spread evenly over the front.  [Roberts 2018, R2 sequence]
std::vector<FacePoint> placePoints() {
  constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532, kTurn = 6.283185307179586;
  std::vector<FacePoint> points;
  for (int n = 1; points.size() < kPoints; ++n) {
    const double z = -0.1 + 1.1 * std::fmod(n * kFirst, 1.0), angle = kTurn * std::fmod(n * kSecond, 1.0);
    const double r = std::sqrt(1 - z * z);
    FacePoint point;
    if (placeAlong(vec3(r * std::cos(angle), r * std::sin(angle), z), point)) points.push_back(point);
  }
  return points;
}

// Eyes, nose and mouth without the cheeks: narrow, as the family knows real cheeks and chins least.
bool isInner(const vec3& p) { return std::abs(p.x) < 18 && p.y > -34 && p.y < 11 && p.z > 18; }

void weigh(std::vector<FacePoint>& points) {
  double sum = 0;
  for (FacePoint& point : points) {
    if (!isInner(point.place)) point.weight *= kBesideWeight;
    sum += double(point.weight);
  }
  for (FacePoint& point : points) point.weight = float(double(point.weight) / sum);
}

// Who lies around whom within the inner face.
std::vector<FaceModel::Inner> findInner(const std::vector<FacePoint>& points) {
  constexpr float kWidth = 7, kReach = 2 * kWidth;
  std::vector<FaceModel::Inner> inner;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!isInner(points[i].place)) continue;
    FaceModel::Inner entry{i, {}};
    float sum = 0;
    for (std::uint32_t j = 0; j < points.size(); ++j) {
      const vec3 apart = points[j].place - points[i].place;
      const float square = glm::dot(apart, apart);
      if (square > kReach * kReach) continue;
      const float share = std::exp(-0.5f * square / (kWidth * kWidth)) * points[j].weight;
      entry.around.push_back({j, share});
      sum += share;
    }
    for (FaceNeighbour& neighbour : entry.around) neighbour.share /= sum;
    inner.push_back(std::move(entry));
  }
  return inner;
}

constexpr std::array kPlaces{&HeadPlaces::rightEye,   &HeadPlaces::leftEye,   &HeadPlaces::noseTip,
                             &HeadPlaces::mouthRight, &HeadPlaces::mouthLeft, &HeadPlaces::chin};

// Variations: in which ways faces differ, by one standard deviation of each.
//   along    mm that each point moves along its normal: a row for each point, a column for each way
//   places   how far the landmarks move
struct Variations {
  Eigen::MatrixXd along;
  std::vector<HeadPlaces> places;
};

HeadShape varied(const HeadTrait& trait, float deviations) {
  HeadShape shape;
  shape.*trait.number += deviations * trait.spread;
  return shape;
}

HeadPlaces half(const HeadPlaces& more, const HeadPlaces& less) {
  HeadPlaces result;
  for (const auto place : kPlaces) result.*place = 0.5f * (more.*place - less.*place);
  return result;
}

// The family's traits; and, for scans whose spacing is nominal, the whole stretched upward or forward.
Variations findVariations(const std::vector<FacePoint>& points, const HeadPlaces& mean) {
  constexpr float kStretch = 0.1f;
  const auto traits = headTraits();
  Variations found{Eigen::MatrixXd(Eigen::Index(points.size()), Eigen::Index(traits.size() + 2)),
                   std::vector<HeadPlaces>(traits.size() + 2)};
  parallelFor(std::ptrdiff_t(traits.size()), [&](std::ptrdiff_t t) {
    const HeadShape less = varied(traits[std::size_t(t)], -1), more = varied(traits[std::size_t(t)], 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const vec3& p = points[i].place;
      found.along(Eigen::Index(i), t) = 0.5 * double(headSkin(p, less) - headSkin(p, more));
    }
    found.places[std::size_t(t)] = half(headPlaces(more), headPlaces(less));
  });
  for (const int axis : {1, 2}) {
    const std::size_t way = traits.size() + std::size_t(axis) - 1;
    for (std::size_t i = 0; i < points.size(); ++i)
      found.along(Eigen::Index(i), Eigen::Index(way)) =
          double(kStretch * points[i].place[axis] * points[i].normal[axis]);
    for (const auto place : kPlaces) (found.places[way].*place)[axis] = kStretch * (mean.*place)[axis];
  }
  return found;
}

// What moves, turns and scales the whole: shifts of x, y, z; turns about them; size.
using Motion = Eigen::Matrix<double, 7, 1>;
Motion motionAt(const vec3& p, const vec3& n) {
  const vec3 turn = glm::cross(p, n);
  Motion m;
  m << double(n.x), double(n.y), double(n.z), double(turn.x), double(turn.y), double(turn.z),
      double(glm::dot(p, n));
  return m;
}

vec3 moved(const vec3& p, const Motion& m) {
  const vec3 turn{float(m[3]), float(m[4]), float(m[5])};
  return vec3{float(m[0]), float(m[1]), float(m[2])} + glm::cross(turn, p) + float(m[6]) * p;
}

// Takes out of every variation what motions of the whole do as well.
void takeOutMotion(const std::vector<FacePoint>& points, const HeadPlaces& mean, Variations& variations) {
  Eigen::MatrixXd motions(Eigen::Index(points.size()), 7);
  Eigen::VectorXd weights(Eigen::Index(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    motions.row(Eigen::Index(i)) = motionAt(points[i].place, points[i].normal).transpose();
    weights[Eigen::Index(i)] = double(points[i].weight);
  }
  const Eigen::MatrixXd weighted = weights.asDiagonal() * motions;
  const Eigen::MatrixXd best =
      (motions.transpose() * weighted).ldlt().solve(weighted.transpose() * variations.along);
  variations.along -= motions * best;
  for (std::size_t way = 0; way < variations.places.size(); ++way) {
    const Motion motion = best.col(Eigen::Index(way));
    for (const auto place : kPlaces) variations.places[way].*place -= moved(mean.*place, motion);
  }
}

void findModes(FaceModel& model) {
  Variations variations = findVariations(model.points, model.places);
  takeOutMotion(model.points, model.places, variations);
  const Eigen::MatrixXd& along = variations.along;
  Eigen::VectorXd weights(along.rows());
  for (Eigen::Index i = 0; i < along.rows(); ++i) weights[i] = double(model.points[std::size_t(i)].weight);
  const Eigen::MatrixXd weighted = weights.asDiagonal() * along;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> principal(along.transpose() * weighted);
  for (int mode = 0; mode < kFaceModes; ++mode) {
    const Eigen::VectorXd mix = principal.eigenvectors().col(along.cols() - 1 - mode);
    const Eigen::VectorXd moves = along * mix;
    for (std::size_t i = 0; i < model.points.size(); ++i)
      model.points[i].along[std::size_t(mode)] = float(moves[Eigen::Index(i)]);
    for (const auto place : kPlaces) {
      vec3 sum(0);
      for (std::size_t way = 0; way < variations.places.size(); ++way)
        sum += float(mix[Eigen::Index(way)]) * variations.places[way].*place;
      model.moves[std::size_t(mode)].*place = sum;
    }
  }
}

FaceModel makeModel() {
  FaceModel model;
  model.points = placePoints();
  weigh(model.points);
  model.inner = findInner(model.points);
  model.places = headPlaces(HeadShape{});
  findModes(model);
  return model;
}

}  // namespace

const FaceModel& faceModel() {
  static const FaceModel kModel = makeModel();
  return kModel;
}

}  // namespace sonoskin
