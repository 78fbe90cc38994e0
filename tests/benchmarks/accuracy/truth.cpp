#include "tests/benchmarks/accuracy/truth.h"

#include <cmath>

#include "core/phantom/phantom.h"
#include "core/phantom/phantom_geometry.h"
#include "core/phantom/phantom_model.h"
#include "tests/benchmarks/accuracy/point_tree.h"

namespace sonoskin::accuracy {
namespace {

constexpr double kReach = 8;         // mm; farther off no method is right
constexpr double kLipschitz = 1.25;  // of the phantom's distances
constexpr double kOnSurface = 0.05;  // mm; a foot point this near has been found

glm::dvec3 gradientOf(const Interface& interface, const glm::dvec3& p) {
  constexpr double h = 0.02;
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0);
    step[axis] = h;
    gradient[axis] = (interface(p + step) - interface(p - step)) / (2 * h);
  }
  return gradient;
}

}  // namespace

double signedDistance(const Interface& interface, const glm::dvec3& world, const glm::dvec3& unit,
                      glm::dvec3* foot) {
  const double here = interface(world);
  if (std::abs(here) > kReach * kLipschitz) return kFar;
  glm::dvec3 q = world;
  double value = here, best = kFar;
  for (int step = 0; step < 12; ++step) {
    const glm::dvec3 gradient = gradientOf(interface, q) * unit;  // per unit
    const double slope = std::max(glm::dot(gradient, gradient), 1e-6);
    const glm::dvec3 back = (world - q) / unit;
    q = world - unit * (gradient * ((value + glm::dot(gradient, back)) / slope));
    value = interface(q);
    const double length = glm::length((world - q) / unit);
    if (std::abs(value) < kOnSurface && length < best) {
      best = length;
      if (foot) *foot = q;
    }
    if (std::abs(value) < 1e-3) break;
  }
  return std::copysign(best, here);
}

Truth::Truth(const PhantomOptions& options) : geometry_(phantomGeometry(options)) {
  const auto model = std::make_shared<const PhantomModel>(options);
  skin_ = [model](const glm::dvec3& p) { return model->skin(p); };
  other_ = [model](const glm::dvec3& p) { return model->other(p); };
  const Mesh skin = makePhantomTruth(options);
  for (std::size_t v = 0; v < skin.positions.size(); ++v)
    if (skin.visibility[v] >= 0.5f) visible_.emplace_back(geometry_.toIndex(glm::dvec3(skin.positions[v])));
  tree_ = std::make_unique<PointTree>(visible_);
}

Truth::~Truth() = default;

bool Truth::nearVisible(const glm::vec3& index, float radius) const {
  return tree_->distance(index) <= radius;
}

double Truth::toSkin(const glm::dvec3& world, const glm::dvec3& unit) const {
  return signedDistance(skin_, world, unit);
}

double Truth::toFluidSurface(const glm::dvec3& world) const {
  double nearest = kFar;
  const auto look = [&](const Interface& interface, const Interface& other) {
    glm::dvec3 foot;
    const double distance = std::abs(signedDistance(interface, world, geometry_.spacing, &foot));
    if (distance < nearest && other(foot) >= 0) nearest = distance;
  };
  look(skin_, other_);
  look(other_, skin_);
  return nearest;
}

}  // namespace sonoskin::accuracy
