#pragma once

#include "core/skin/dipole.h"
#include "core/skin/spectrum.h"

namespace sonoskin {

// Pigments: what colours skin.
//   melanin     share of the epidermis, 0 .. 1        blood       share of the dermis, 0 .. 1
//   oxygen      saturation of the blood, 0 .. 1       epidermis   its thickness, mm
struct Pigments {
  double melanin = 0.005, blood = 0.010, oxygen = 0.80, epidermis = 0.06;
};

// bloodAbsorption: of whole blood with 170 g of haemoglobin per litre, 1/mm, per wavelength.
//   data   molar extinction of haemoglobin compiled by S. Prahl (Gratzer; Kollias), every 10 nm from 400 to
//          700. All 31 lines were compared with a public copy of the compilation (github.com/droumis/spectra,
//          data_hb.csv): equal. From 630 nm up another set (Moaveni 1970, also on omlc.org) is 11 % higher
//          for HbO2 and 17 % lower for Hb at 630; the published compilation is kept
Spectrum bloodAbsorption(double oxygen);

// epidermisAbsorption: of melanin (70 % eumelanin, 30 % pheomelanin) in bloodless skin, 1/mm.
//                                                                         [Jacques 1998; Donner, Jensen 2006]
Spectrum epidermisAbsorption(double melanin);

// epidermisTransmittance: share of diffuse light that passes the epidermis once: 2 E_3(sigma_a t).
Spectrum epidermisTransmittance(double melanin, double thickness);

// dermis: the medium below at that step of wavelength: blood in bloodless skin, index 1.4.
//                                                                                       [Donner, Jensen 2006]
ScatteringMedium dermis(double blood, double oxygen, int step);

// dermisReflectance: the dipole's total per wavelength.
Spectrum dermisReflectance(double blood, double oxygen);

// skinAlbedo: linear Rec. 709: down through the epidermis, back from the dermis, up again.
glm::dvec3 skinAlbedo(const Pigments& pigments);

// dermisRgb: the dermis at 610, 550 and 460 nm, which stand for red, green and blue where light spreads.
MediumRgb dermisRgb(const Pigments& pigments);

}  // namespace sonoskin
