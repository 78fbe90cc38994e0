#pragma once

#include <array>
#include <glm/glm.hpp>

namespace sonoskin {

// Wavelengths: those at which spectra are given: 400 to 700 nm in steps of 10.
constexpr int kWavelengths = 31;
constexpr double wavelength(int i) { return 400.0 + 10 * i; }
using Spectrum = std::array<double, kWavelengths>;

// spectralWeights: linear Rec. 709 of reflectance 1 in one step of wavelength and 0 elsewhere; over all steps
// they sum to (1, 1, 1): a white of equal energy is white.
//                                                        [CIE 1931 by the fits of Wyman, Sloan, Shirley 2013]
const std::array<glm::dvec3, kWavelengths>& spectralWeights();

// linearColour: linear Rec. 709 of a reflectance; may lie outside the gamut.
glm::dvec3 linearColour(const Spectrum& reflectance);

}  // namespace sonoskin
