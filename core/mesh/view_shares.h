#pragma once

#include <vector>

#include "core/mesh/mesh.h"
#include "core/volume/scan.h"

namespace sonoskin {

// ViewShares: what each part of a surface fills of the probe's view, 0 to 1, as shares of the most that one fills.
//   centred   beams near the middle one count more
//   seen      all beams count alike
struct ViewShares {
  std::vector<double> centred, seen;
};

// viewShares: how much of the probe's view each part of a surface fills.
//   partOfTriangle  numbers below `parts`
//   middle   a point on the middle beam, such as the centre of the volume, mm
//   method   depth buffer of 256 x 256 beams: by angle around an apex, by place for parallel beams. Each beam gives
//            the part that it meets first the weight exp(-ρ²/(2 · 0.35²)), ρ: distance from the middle beam in
//            halves of the larger extent of the surface. So a face wins against a larger wall behind or beside it,
//            against what lies inside it, and against specks in front.
//   output   one per part; the best has 1
ViewShares viewShares(const Mesh& mesh, const std::vector<std::uint32_t>& partOfTriangle, std::size_t parts,
                      const Beam& beam, const glm::dvec3& middle);

}  // namespace sonoskin
