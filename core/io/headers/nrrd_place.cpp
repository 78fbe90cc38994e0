#include "core/io/headers/nrrd_place.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/headers/nrrd_axes.h"
#include "core/io/headers/nrrd_space.h"
#include "core/io/headers/units.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Axis = NrrdAxis;
using Centre = NrrdAxis::Centre;
constexpr double kNone = NrrdAxis::kNone;

// Span: the spacing of an axis without a direction, with its sign, and the place of its first sample; NaN:
// not told.
struct Span {
  double spacing = kNone, first = kNone;
};

// [NRRD, "centers"]: samples of cells lie in the middle of as many cells between min and max, those of nodes
// on both ends.
Span spanOf(const Axis& axis, std::int64_t size, const fs::path& path) {
  Span span{axis.spacing, axis.least};
  if (std::isnan(axis.least)) return span;
  const double extent = axis.most - axis.least, cells = double(size),
               nodes = double(std::max<std::int64_t>(size - 1, 1));
  Centre centre = axis.centre;
  const auto fits = [&](double count) {
    return std::abs(axis.spacing * count - extent) <= 1e-3 * std::abs(extent);
  };
  const bool both = !std::isnan(extent) && !std::isnan(axis.spacing);
  if (both && centre == Centre::unsaid) centre = fits(cells) ? Centre::cell : Centre::node;
  require(!both || fits(centre == Centre::node ? nodes : cells),
          "The spacings in {} contradict its axis mins and maxs; correct the header.", path.string());
  if (centre == Centre::unsaid)
    log(LogLevel::warning,
        "The file does not say whether axis mins and maxs mean cells or nodes; cells are assumed.");
  if (std::isnan(span.spacing)) span.spacing = extent / (centre == Centre::node ? nodes : cells);
  if (centre != Centre::node && !std::isnan(span.spacing)) span.first += span.spacing / 2;
  return span;
}

// The mm of one unit of an axis that has no direction, or whose file has no units of space.
double unitOf(const NrrdFields& nrrd, const Axis& axis) {
  return nrrd["spaceunits"].empty() ? millimetresOrWarn(axis.unit) : 1;
}

void placeUndirected(const NrrdFields& nrrd, const std::vector<Axis>& axes, const NrrdSpace& space,
                     DeclaredData& data, const fs::path& path) {
  Geometry& g = data.stored.geometry;
  for (int a = 0; a < 3; ++a) {
    const std::size_t n = std::size_t(data.spaceAxes[std::size_t(a)]);
    const Span span = spanOf(axes[n], data.sizes[n], path);
    const double unit =
        nrrd["spaceunits"].empty() ? millimetresOrWarn(axes[n].unit) : std::abs(space.toLps[a]);
    const double sign = glm::sign(space.toLps[a]) * (span.spacing < 0 ? -1 : 1);
    data.stored.spacingKnown = data.stored.spacingKnown && !std::isnan(span.spacing);
    g.spacing[a] = std::isnan(span.spacing) ? 1 : std::abs(span.spacing) * unit;
    g.direction[a] = sign * glm::dmat3(1)[a];
    g.origin[a] = std::isnan(span.first) ? 0 : span.first * unit * glm::sign(space.toLps[a]);
  }
}

// The direction of the axis that has none: across the two others.
void completeDirections(Geometry& g, const std::array<bool, 3>& given, const fs::path& path) {
  for (int a = 0; a < 3; ++a) {
    if (given[std::size_t(a)]) continue;
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    require(given[std::size_t(b)] && given[std::size_t(c)],
            "{} gives a direction to one axis of space alone; correct the header.", path.string());
    const glm::dvec3 across = glm::cross(g.direction[b], g.direction[c]);
    g.direction[a] = glm::length(across) > 0 ? glm::normalize(across) : across;
  }
}

void placeDirected(const NrrdFields& nrrd, const std::vector<Axis>& axes, const NrrdSpace& space,
                   DeclaredData& data, const fs::path& path) {
  Geometry& g = data.stored.geometry;
  std::array<bool, 3> given{};
  for (int a = 0; a < 3; ++a) {
    const Axis& axis = axes[std::size_t(data.spaceAxes[std::size_t(a)])];
    const bool spaced = !std::isnan(axis.spacing);
    given[std::size_t(a)] = axis.direction.has_value();
    if (!axis.direction) {
      g.spacing[a] = spaced ? std::abs(axis.spacing) * unitOf(nrrd, axis) : 1;
      data.stored.spacingKnown = data.stored.spacingKnown && spaced;
      continue;
    }
    const glm::dvec3 step = space.world(*axis.direction) * unitOf(nrrd, axis);
    g.spacing[a] = glm::length(step);
    require(g.spacing[a] > 0, "An axis in {} has a direction without length; correct the header.",
            path.string());
    g.direction[a] = step / g.spacing[a];
  }
  completeDirections(g, given, path);
}

void placeOrigin(const NrrdFields& nrrd, const std::vector<Axis>& axes, const NrrdSpace& space,
                 DeclaredData& data, const fs::path& path) {
  const auto origins = nrrdVectors(nrrd["spaceorigin"], path);
  if (origins.empty() || !origins[0]) return;
  require(origins.size() == 1 && origins[0]->size() == std::size_t(space.dimension),
          "The space origin in {} is not {} numbers; correct the header.", path.string(), space.dimension);
  const Axis& first = axes[std::size_t(data.spaceAxes[0])];
  data.stored.geometry.origin = space.world(*origins[0]) * (first.direction ? unitOf(nrrd, first) : 1);
}

double stepSeconds(const Axis& axis, const NrrdSpace& space) {
  double step = std::abs(axis.spacing) * secondsIn(axis.unit).value_or(0);
  if (axis.direction && space.hasTime) step = std::abs(axis.direction->back()) * space.timeUnit;
  return std::isfinite(step) ? step : 0;
}

}  // namespace

void placeNrrd(const NrrdFields& nrrd, DeclaredData& data, const fs::path& path) {
  const std::vector<Axis> axes = nrrdAxes(nrrd, data.sizes.size(), path);
  const NrrdSpace space = nrrdSpace(nrrd, path);
  for (const Axis& axis : axes)
    require(!axis.direction || axis.direction->size() == std::size_t(space.dimension),
            "The directions of the axes in {} are not vectors of {} numbers; correct the header.",
            path.string(), space.dimension);
  assignAxes(nrrdRoles(axes, data.sizes, path), data, path, placesManyFrames(nrrd.keys));
  data.stored.spacingKnown = true;
  const bool directed = std::any_of(data.spaceAxes.begin(), data.spaceAxes.end(),
                                    [&](int a) { return axes[std::size_t(a)].direction.has_value(); });
  if (directed && !data.poses)
    placeDirected(nrrd, axes, space, data, path);
  else
    placeUndirected(nrrd, axes, space, data, path);
  placeOrigin(nrrd, axes, space, data, path);
  if (data.timeAxis >= 0) data.stored.stepSeconds = stepSeconds(axes[std::size_t(data.timeAxis)], space);
}

}  // namespace sonoskin
