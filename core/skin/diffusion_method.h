#pragma once

namespace sonoskin {

// DiffusionMethod: who spreads the light below the skin; what stands later comes closer to the integral.
//   blurs       in the atlas, on the GPU: follow the mouse; wrong in folds and across charts   [theory/skin.md, 5]
//   points      from point to point on the surface, on the CPU                                 [theory/skin.md, 6.3]
//   reference   the integral over the surface, light through thin parts included; slow         [theory/skin.md, 6.1]
enum class DiffusionMethod { blurs, points, reference };

}  // namespace sonoskin
