#pragma once

#include <array>
#include <glm/glm.hpp>

namespace sonoskin {

// ChartAxis: a parallel projection. u, v, toward: right-handed and unit; `toward` points to the one who looks, so that
// triangles that are counter-clockwise seen from there are so in (u, v).
struct ChartAxis {
  glm::vec3 u, v, toward;
  glm::vec3 project(const glm::vec3& p) const {
    return {glm::dot(p, u), glm::dot(p, v), glm::dot(p, toward)};
  }
};

// chartAxes: the faces and corners of a cube of which one face looks to `front`; that one comes first. World z, the
// patient's head, is up in it.
constexpr std::size_t kChartAxes = 14;
std::array<ChartAxis, kChartAxes> chartAxes(const glm::vec3& front);

}  // namespace sonoskin
