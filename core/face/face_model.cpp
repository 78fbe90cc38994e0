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

bool isInner(const vec3& p) { return std::abs(p.x) < 25 && p.y > -40 && p.y < 11 && p.z > 18; }

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
  constexpr float kWidth = 8, kReach = 2 * kWidth;
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

HeadShape varied(const HeadTrait& trait, float deviations) {
  HeadShape shape;
  shape.*trait.number += deviations * trait.spread;
  return shape;
}

// What each trait does to the points: mm along the normal for one standard deviation.
Eigen::MatrixXd traitMoves(const std::vector<FacePoint>& points) {
  const auto traits = headTraits();
  Eigen::MatrixXd moves(Eigen::Index(points.size()), Eigen::Index(traits.size()));
  parallelFor(std::ptrdiff_t(traits.size()), [&](std::ptrdiff_t t) {
    const HeadShape less = varied(traits[std::size_t(t)], -1), more = varied(traits[std::size_t(t)], 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const vec3& p = points[i].place;
      moves(Eigen::Index(i), t) = 0.5 * double(headSkin(p, less) - headSkin(p, more));
    }
  });
  return moves;
}

constexpr std::array kPlaces{&HeadPlaces::rightEye,   &HeadPlaces::leftEye,   &HeadPlaces::noseTip,
                             &HeadPlaces::mouthRight, &HeadPlaces::mouthLeft, &HeadPlaces::chin};

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

// Takes out of every trait what motions of the whole do as well; returns those motions, a column per trait.
Eigen::MatrixXd takeOutMotion(const std::vector<FacePoint>& points, Eigen::MatrixXd& moves) {
  Eigen::MatrixXd motions(Eigen::Index(points.size()), 7);
  Eigen::VectorXd weights(Eigen::Index(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    motions.row(Eigen::Index(i)) = motionAt(points[i].place, points[i].normal).transpose();
    weights[Eigen::Index(i)] = double(points[i].weight);
  }
  const Eigen::MatrixXd weighted = weights.asDiagonal() * motions;
  const Eigen::MatrixXd best = (motions.transpose() * weighted).ldlt().solve(weighted.transpose() * moves);
  moves -= motions * best;
  return best;
}

void findModes(FaceModel& model) {
  Eigen::MatrixXd moves = traitMoves(model.points);
  const Eigen::MatrixXd motions = takeOutMotion(model.points, moves);
  Eigen::VectorXd roots(moves.rows());
  for (Eigen::Index i = 0; i < roots.size(); ++i)
    roots[i] = std::sqrt(double(model.points[std::size_t(i)].weight));
  const Eigen::MatrixXd weighted = roots.asDiagonal() * moves;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> principal(weighted.transpose() * weighted);
  const auto traits = headTraits();
  for (int mode = 0; mode < kFaceModes; ++mode) {
    const Eigen::VectorXd mix = principal.eigenvectors().col(Eigen::Index(traits.size()) - 1 - mode);
    const Eigen::VectorXd along = moves * mix;
    for (std::size_t i = 0; i < model.points.size(); ++i)
      model.points[i].along[std::size_t(mode)] = float(along[Eigen::Index(i)]);
    for (const auto place : kPlaces) model.moves[std::size_t(mode)].*place = vec3(0);
    for (std::size_t t = 0; t < traits.size(); ++t) {
      const HeadPlaces less = headPlaces(varied(traits[t], -1)), more = headPlaces(varied(traits[t], 1));
      const Motion motion = motions.col(Eigen::Index(t));
      for (const auto place : kPlaces)
        model.moves[std::size_t(mode)].*place +=
            float(mix[Eigen::Index(t)]) *
            (0.5f * (more.*place - less.*place) - moved(model.places.*place, motion));
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
