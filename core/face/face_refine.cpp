#include "core/face/face_refine.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace sonoskin {
namespace {

using glm::vec3;

constexpr int kMotion = 7, kUnknowns = kMotion + kFaceModes;
using Row = Eigen::Matrix<double, kUnknowns, 1>;
using System = Eigen::Matrix<double, kUnknowns, kUnknowns>;

// Residual: how far one model point lies off the surface, and how that changes with each unknown.
struct Residual {
  Row jacobian;
  double off = 0, weight = 0;
};

bool residualOf(const FacePoint& point, const FacePlacement& face, const FaceSpace& space, float reach,
                Residual& residual) {
  const vec3 arm = face.scale * (face.turn * face.inHead(point)), place = face.at + arm;
  const Surfel* surfel = space.nearest(place);
  if (!surfel) return false;
  const vec3 normal = face.normal(point);
  const float agrees = glm::dot(surfel->normal, normal);
  if (agrees < 0.3f) return false;
  const float off = glm::dot(place - surfel->place, surfel->normal);
  const float far = space.kind(place) == FaceSpace::Kind::free ? 2 * reach : reach;
  const float share = 1 - off * off / (far * far);
  if (share <= 0) return false;
  const vec3 turn = glm::cross(arm, surfel->normal);
  residual.jacobian << double(surfel->normal.x), double(surfel->normal.y), double(surfel->normal.z),
      double(turn.x), double(turn.y), double(turn.z), double(glm::dot(arm, surfel->normal)),
      Eigen::Matrix<double, kFaceModes, 1>::Zero();
  for (int m = 0; m < kFaceModes; ++m)
    residual.jacobian[kMotion + m] = double(face.scale * point.along[std::size_t(m)] * agrees);
  residual.off = double(off);
  residual.weight = double(point.weight * agrees * share * share);
  return true;
}

void apply(const Row& step, FacePlacement& face) {
  const vec3 turn{float(step[3]), float(step[4]), float(step[5])};
  const float angle = glm::length(turn);
  if (angle > 0) face.turn = glm::mat3_cast(glm::angleAxis(angle, turn / angle)) * face.turn;
  face.at += vec3{float(step[0]), float(step[1]), float(step[2])};
  face.scale *= std::exp(std::clamp(float(step[6]), -0.15f, 0.15f));
  for (int m = 0; m < kFaceModes; ++m)
    face.modes[std::size_t(m)] = std::clamp(face.modes[std::size_t(m)] + float(step[kMotion + m]), -3.f, 3.f);
}

}  // namespace

FacePlacement refineFace(const FacePlacement& start, const FaceSpace& space, const SizePrior& size,
                         const RefineSteps& steps) {
  // Neighbours tell much the same: so many independent measurements there are, each good to a millimetre.
  constexpr double kMeasurements = 150, kEnough = 0.1, kModePrior = 0.3;
  const FaceModel& model = faceModel();
  const std::size_t count = std::min(steps.points, model.points.size());
  FacePlacement face = start;
  for (int step = 0; step < steps.steps; ++step) {
    const float t = steps.steps > 1 ? float(step) / float(steps.steps - 1) : 1;
    const float reach = steps.firstReach + t * (steps.lastReach - steps.firstReach);
    System system = System::Zero();
    Row right = Row::Zero();
    double weights = 0, all = 0;
    Residual residual;
    for (std::size_t i = 0; i < count; ++i) {
      all += double(model.points[i].weight);
      if (!residualOf(model.points[i], face, space, reach, residual)) continue;
      weights += residual.weight;
      system.selfadjointView<Eigen::Lower>().rankUpdate(residual.jacobian, residual.weight);
      right -= residual.weight * residual.off * residual.jacobian;
    }
    if (weights < kEnough * all) return step == 0 ? start : face;
    system *= kMeasurements / all;
    right *= kMeasurements / all;
    const double spread = double(size.spread) * double(size.spread);
    system(6, 6) += 1 / spread;
    right[6] -= std::log(double(face.scale / size.middle)) / spread;
    for (int m = 0; m < kFaceModes; ++m) {
      system(kMotion + m, kMotion + m) += steps.modes ? kModePrior : 1e12;
      if (steps.modes) right[kMotion + m] -= kModePrior * double(face.modes[std::size_t(m)]);
    }
    for (int n = 0; n < 6; ++n) system(n, n) += 1e-3;
    apply(system.selfadjointView<Eigen::Lower>().ldlt().solve(right), face);
  }
  return face;
}

}  // namespace sonoskin
