#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/phantom/sdf.h"

namespace sonoskin {

// WorldDistance: a signed distance by world position, mm.
using WorldDistance = std::function<float(const glm::vec3&)>;

// Membrane: thin tissue between the baby and the wall: a strand, thicker at both ends, or a sheet between two
// of them.
//   corners     on the skin, in the wall; of a sheet then on the wall and the skin again, in order around it
//   thickness   mm
struct Membrane {
  std::array<glm::vec3, 4> corners;
  float thickness;
  bool sheet;
};

// spanMembranes: membranes from places on the skin toward the wall, the first a strand, the second a sheet, and
// so on; 0.5 to 1.5 mm thick. Where the wall is not met, there is none.
//   starts     on the skin; every sheet uses the next two, every strand one
//   towards    unit, for each start the direction in which the wall lies
std::vector<Membrane> spanMembranes(const std::vector<glm::vec3>& starts,
                                    const std::vector<glm::vec3>& towards, const WorldDistance& skin,
                                    const WorldDistance& wall, std::uint32_t key);

// membraneDistance: signed distance to the nearest of them; large without any.
float membraneDistance(const std::vector<Membrane>& membranes, const glm::vec3& p);

}  // namespace sonoskin
