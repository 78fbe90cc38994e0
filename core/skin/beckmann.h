#pragma once

namespace sonoskin {

// kNormalReflectance: F0, of skin seen straight on (index 1.4).
constexpr double kNormalReflectance = 0.028;

// beckmannDensity: D of facets whose normal makes an angle of that cosine (0 < cosine <= 1) with the
// surface's; the slopes have the root mean square m. int D cos d omega = 1: the 1 / pi is in it.
//                                                                                             [Beckmann 1963]
double beckmannDensity(double cosine, double m);

// schlickFresnel: F0 + (1 - F0) (1 - v.h)^5.                                                   [Schlick 1994]
double schlickFresnel(double cosine, double f0 = kNormalReflectance);

// directionalAlbedo: share of the light from an angle of that cosine (0 .. 1) that the surface's gloss sends
// anywhere: int f cos d omega, f = D F / |l + v|^2, for rho_s = 1.              [Kelemen, Szirmay-Kalos 2001]
//   method   Gauss-Legendre over the facets that send it upward, to 1e-5
//   f0       1 for the white test
double directionalAlbedo(double cosine, double m, double f0 = kNormalReflectance);

// meanAlbedo: its mean over the half space, weighted with the cosine: 2 int albedo c dc.
double meanAlbedo(double m);

}  // namespace sonoskin
