#include "core/mesh/atlas/atlas_axes.h"

#include <cmath>

namespace sonoskin {
namespace {

ChartAxis axisToward(const glm::vec3& toward, const glm::vec3& up, const glm::vec3& instead) {
  const glm::vec3 side = std::abs(glm::dot(toward, up)) < 0.95f ? up : instead;
  const glm::vec3 u = glm::normalize(glm::cross(side, toward));
  return {u, glm::cross(toward, u), toward};
}

}  // namespace

std::array<ChartAxis, kChartAxes> chartAxes(const glm::vec3& front) {
  const ChartAxis cube = axisToward(glm::normalize(front), {0, 0, 1}, {0, -1, 0});
  const auto turned = [&](float u, float v, float w) {
    return axisToward(glm::normalize(u * cube.u + v * cube.v + w * cube.toward), cube.v, cube.toward);
  };
  return {turned(0, 0, 1),  turned(0, 0, -1),  turned(1, 0, 0),   turned(-1, 0, 0),  turned(0, 1, 0),
          turned(0, -1, 0), turned(1, 1, 1),   turned(-1, 1, 1),  turned(1, -1, 1),  turned(-1, -1, 1),
          turned(1, 1, -1), turned(-1, 1, -1), turned(1, -1, -1), turned(-1, -1, -1)};
}

}  // namespace sonoskin
