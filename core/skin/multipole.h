#pragma once

#include "core/skin/dipole.h"

namespace sonoskin {

// Plate: shares of the light that a layer sends back and lets through.
struct Plate {
  double reflectance = 0, transmittance = 0;
};

// plateOf: a plate of that thickness, mm, for light in stripes of s 1/mm (0: even light).
//                                                                                       [Donner, Jensen 2005]
// Ours: the infinite sums of image sources are geometric series, taken in closed form.
//   precondition   thickness above the mean free path 1 / (sigma_a + sigma_s'); the model means something
//                  above 1.5 of them only
Plate plateOf(const ScatteringMedium& medium, double thickness, double s = 0);

// onTop: a plate that lies on another.                                                  [Donner, Jensen 2005]
Plate onTop(const Plate& upper, const Plate& lower);

}  // namespace sonoskin
