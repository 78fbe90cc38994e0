#pragma once

#include "core/base/progress.h"
#include "core/mesh/atlas/atlas_maps.h"

namespace sonoskin {

// stretchMap: mm per texel along u and v, from the positions' slopes smoothed over 0.5 mm of a body on each row and column as far
// as there is a surface; between 0.2 and 5 times the mean, and the larger at most twice the smaller. Where nothing is,
// that of a flat chart.
//   position  as in AtlasMaps
//   cost      2 million texels: 0.1 s on two cores
//   errors    Cancelled
std::vector<glm::vec2> stretchMap(const Atlas& atlas, const std::vector<glm::vec4>& position,
                                  const Progress& progress = {});

}  // namespace sonoskin
