#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace sonoskin {

// MeasureKind: what is measured between marks: the distance of two, the angle at the second of three, the area within three or
// more.
enum class MeasureKind { distance, angle, area };
constexpr std::array<const char*, 3> enumNames(MeasureKind) { return {"distance", "angle", "area"}; }

// Measure: marks in the world, mm, in the order in which they were set. Those of an area lie in one plane.
struct Measure {
  MeasureKind kind = MeasureKind::distance;
  std::vector<glm::dvec3> marks;
  friend bool operator==(const Measure&, const Measure&) = default;
};

// isComplete: whether it has the marks that it needs: 2, 3, at least 3. isFull: whether it takes no more: an area takes any number.
bool isComplete(const Measure& measure);
bool isFull(const Measure& measure);

// valueOf: mm, degrees (0 to 180; 0 where a side has no length) or mm²; 0 while it is not complete. An area whose border crosses itself
// counts with the signs of its parts.
double valueOf(const Measure& measure);

// measureText: the value with its unit: "12.3 mm", "45.0°", "123 mm²"; empty while it is not complete.
std::string measureText(const Measure& measure);

}  // namespace sonoskin
