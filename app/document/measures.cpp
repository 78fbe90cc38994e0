#include "app/document/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

std::size_t leastMarks(MeasureKind kind) { return kind == MeasureKind::distance ? 2 : 3; }

double angleAt(const glm::dvec3& middle, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 u = a - middle, v = b - middle;
  const double lengths = glm::length(u) * glm::length(v);
  if (!(lengths > 0)) return 0;
  // The sine is exact where the cosine is not, near 0 and 180 degrees.
  return glm::degrees(std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
}

// By the sum of the triangles about the first mark.
double areaWithin(const std::vector<glm::dvec3>& marks) {
  glm::dvec3 sum(0);
  for (std::size_t n = 1; n + 1 < marks.size(); ++n)
    sum += glm::cross(marks[n] - marks[0], marks[n + 1] - marks[0]);
  return 0.5 * glm::length(sum);
}

}  // namespace

bool isComplete(const Measure& measure) {
  const std::size_t least = leastMarks(measure.kind);
  return measure.kind == MeasureKind::area ? measure.marks.size() >= least : measure.marks.size() == least;
}

bool isFull(const Measure& measure) {
  return measure.kind != MeasureKind::area && measure.marks.size() >= leastMarks(measure.kind);
}

double valueOf(const Measure& measure) {
  if (!isComplete(measure)) return 0;
  const auto& marks = measure.marks;
  switch (measure.kind) {
    case MeasureKind::distance:
      return glm::distance(marks[0], marks[1]);
    case MeasureKind::angle:
      return angleAt(marks[1], marks[0], marks[2]);
    case MeasureKind::area:
      return areaWithin(marks);
  }
  return 0;
}

std::string measureText(const Measure& measure) {
  if (!isComplete(measure)) return {};
  const double value = valueOf(measure);
  switch (measure.kind) {
    case MeasureKind::distance:
      return fmt::format("{:.1f} mm", value);
    case MeasureKind::angle:
      return fmt::format("{:.1f}°", value);
    case MeasureKind::area:
      return fmt::format("{:.{}f} mm²", value, value < 100 ? 1 : 0);
  }
  return {};
}

}  // namespace sonoskin
