#pragma once

#include <array>

namespace sonoskin {

// ScatteringMedium: what light meets below the surface, for one colour.
//   absorption   sigma_a, 1/mm, >= 0
//   scattering   sigma_s', reduced, 1/mm, > 0
//   eta          refractive index, 1 .. 2
struct ScatteringMedium {
  double absorption = 0, scattering = 1, eta = 1.3;
};

// MediumRgb: red, green, blue.
using MediumRgb = std::array<ScatteringMedium, 3>;

// jensenSkin: "skin1" of the published measurements, index 1.3.     [Jensen, Marschner, Levoy, Hanrahan 2001]
MediumRgb jensenSkin();

// Dipole: a real source below the surface and a virtual one above it.                    [Jensen et al. 2001]
//   albedo       alpha' = sigma_s' / (sigma_a + sigma_s')
//   decay        sigma_tr, 1/mm
//   real         z_r, depth of the real source, mm; virtualSource: z_v, height of the virtual one
struct Dipole {
  double albedo = 0, decay = 0, real = 0, virtualSource = 0;
};
Dipole makeDipole(const ScatteringMedium& medium);

// internalReflection: A = (1 + F_dr) / (1 - F_dr) for an index eta >= 1.
double internalReflection(double eta);

// diffuseReflectance: R_d(r), 1/mm^2: light that leaves at r mm from where a unit of it went in.
double diffuseReflectance(const Dipole& dipole, double r);

// totalReflectance: its integral over the plane.
double totalReflectance(const Dipole& dipole);

// reflectanceWithin: its integral over the disc of radius r mm.
double reflectanceWithin(const Dipole& dipole, double r);

// reflectanceSpectrum: its Hankel transform at s 1/mm: what is left of stripes of period 2 pi / s.
double reflectanceSpectrum(const Dipole& dipole, double s);

// reflectanceOfHalfPlane: what a plate that is lit where x > 0 shows at x mm.
//   method   quadrature over the lines beside it, to 1e-6
double reflectanceOfHalfPlane(const Dipole& dipole, double x);

}  // namespace sonoskin
