#include "app/document/crop_box.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

double lengthOf(const Geometry& g, int axis) { return (g.dims[axis] - 1) * g.spacing[axis]; }

// The edge of an interval that lies within `reach` of a place: -1, 1, or 0 for none.
int edgeAt(double low, double high, double place, double reach) {
  const double toLow = std::abs(place - low), toHigh = std::abs(place - high);
  if (std::min(toLow, toHigh) > reach) return 0;
  return toLow < toHigh ? -1 : 1;
}

}  // namespace

double sideAt(const Side& side, const RegionOptions& options, const Geometry& geometry) {
  const auto a = std::size_t(side.axis);
  return side.high ? lengthOf(geometry, side.axis) - options.cutHigh[a] : options.cutLow[a];
}

void moveSide(const Side& side, double mm, RegionOptions& options, const Geometry& geometry) {
  const auto a = std::size_t(side.axis);
  const double length = lengthOf(geometry, side.axis);
  const double& other = side.high ? options.cutLow[a] : options.cutHigh[a];
  double& cut = side.high ? options.cutHigh[a] : options.cutLow[a];
  const double least = std::max(1.0, geometry.spacing[side.axis]);
  const double most = std::floor(10 * std::max(0.0, length - other - least)) / 10;
  cut = std::clamp(std::round(10 * (side.high ? length - mm : mm)) / 10, 0.0, most);
}

std::array<glm::dvec3, 2> boxIn(const Geometry& other, const RegionOptions& options,
                                const Geometry& geometry) {
  glm::dvec3 low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = sideAt({axis, false}, options, geometry) / geometry.spacing[axis];
    high[axis] = sideAt({axis, true}, options, geometry) / geometry.spacing[axis];
  }
  return {other.toIndex(geometry.toWorld(low)), other.toIndex(geometry.toWorld(high))};
}

std::array<glm::dvec3, 2> boxCorners(const RegionOptions& options, const Geometry& geometry) {
  const auto [low, high] = boxIn(geometry, options, geometry);
  return {geometry.toWorld(low - 0.5), geometry.toWorld(high + 0.5)};
}

Grip gripAt(const glm::dvec2& upperLeft, const glm::dvec2& lowerRight, const glm::dvec2& mouse,
            double reach) {
  const bool beside = mouse.x < upperLeft.x - reach || mouse.x > lowerRight.x + reach ||
                      mouse.y < upperLeft.y - reach || mouse.y > lowerRight.y + reach;
  if (beside) return {};
  return {edgeAt(upperLeft.x, lowerRight.x, mouse.x, reach),
          edgeAt(upperLeft.y, lowerRight.y, mouse.y, reach)};
}

}  // namespace sonoskin
