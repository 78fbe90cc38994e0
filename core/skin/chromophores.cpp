#include "core/skin/chromophores.h"

#include <cmath>

namespace sonoskin {
namespace {

constexpr double kHaemoglobin = 170;  // g per litre of blood
constexpr double kMolarMass = 64500;  // g per mole
constexpr double kEumelaninShare = 0.7;
constexpr double kIndex = 1.4;

// Molar extinction of oxygenated and of free haemoglobin, 1/cm per mole and litre.
struct Extinction {
  double oxygenated, free;
};
constexpr std::array<Extinction, kWavelengths> kExtinction{{
    {266232, 223296}, {466840, 303956},   {480360, 407560},   {246072, 528600},   {102580, 413280},
    {62816, 103292},  {44480, 23388.8},   {33209.2, 16156.4}, {26629.2, 14550},   {23684.4, 16684},
    {20932.8, 20862}, {20035.2, 25773.6}, {24202.4, 31589.6}, {39956.8, 39036.4}, {53236, 46592},
    {43016, 53412},   {32613.2, 53788},   {44496, 45072},     {50104, 37020},     {14400.8, 28324.4},
    {3200, 14677.2},  {1506, 9443.6},     {942, 6509.6},      {610, 5148.8},      {442, 4345.2},
    {368, 3750.12},   {319.6, 3226.56},   {294, 2795.12},     {277.6, 2407.92},   {276, 2051.96},
    {290, 1794.28},
}};

// Skin without pigment, 1/mm. [Jacques 1998]
double bloodless(double nm) { return 0.0244 + 8.53 * std::exp(-(nm - 154) / 66.2); }

double eumelanin(double nm) { return 6.6e10 * std::pow(nm, -3.33); }
double pheomelanin(double nm) { return 2.9e14 * std::pow(nm, -4.75); }

// Half of the epidermis', 1/mm. [Donner, Jensen 2006]
double dermisScattering(double nm) { return (14.74 * std::pow(nm, -0.22) + 2.2e11 * std::pow(nm, -4)) / 2; }

double bloodAbsorptionAt(double oxygen, int step) {
  const Extinction& e = kExtinction[size_t(step)];
  return std::log(10) / 10 * (oxygen * e.oxygenated + (1 - oxygen) * e.free) * kHaemoglobin / kMolarMass;
}

// E_3, the exponential integral of order 3.
double exponentialIntegral3(double x) {
  if (x < 1e-12) return 0.5;
  return (std::exp(-x) * (1 - x) - x * x * std::expint(-x)) / 2;
}

}  // namespace

Spectrum bloodAbsorption(double oxygen) {
  Spectrum absorption;
  for (int i = 0; i < kWavelengths; ++i) absorption[size_t(i)] = bloodAbsorptionAt(oxygen, i);
  return absorption;
}

Spectrum epidermisAbsorption(double melanin) {
  Spectrum absorption;
  for (int i = 0; i < kWavelengths; ++i) {
    const double nm = wavelength(i);
    const double pigment = kEumelaninShare * eumelanin(nm) + (1 - kEumelaninShare) * pheomelanin(nm);
    absorption[size_t(i)] = melanin * pigment + (1 - melanin) * bloodless(nm);
  }
  return absorption;
}

Spectrum epidermisTransmittance(double melanin, double thickness) {
  Spectrum passed = epidermisAbsorption(melanin);
  for (double& value : passed) value = 2 * exponentialIntegral3(value * thickness);
  return passed;
}

ScatteringMedium dermis(double blood, double oxygen, int step) {
  const double nm = wavelength(step);
  return {blood * bloodAbsorptionAt(oxygen, step) + (1 - blood) * bloodless(nm), dermisScattering(nm),
          kIndex};
}

Spectrum dermisReflectance(double blood, double oxygen) {
  Spectrum reflectance;
  for (int i = 0; i < kWavelengths; ++i)
    reflectance[size_t(i)] = totalReflectance(makeDipole(dermis(blood, oxygen, i)));
  return reflectance;
}

glm::dvec3 skinAlbedo(const Pigments& pigments) {
  const Spectrum passed = epidermisTransmittance(pigments.melanin, pigments.epidermis);
  Spectrum reflectance = dermisReflectance(pigments.blood, pigments.oxygen);
  for (size_t i = 0; i < kWavelengths; ++i) reflectance[i] *= passed[i] * passed[i];
  return linearColour(reflectance);
}

MediumRgb dermisRgb(const Pigments& pigments) {
  constexpr int kRed = 21, kGreen = 15, kBlue = 6;
  static_assert(wavelength(kRed) == 610 && wavelength(kGreen) == 550 && wavelength(kBlue) == 460);
  return {dermis(pigments.blood, pigments.oxygen, kRed), dermis(pigments.blood, pigments.oxygen, kGreen),
          dermis(pigments.blood, pigments.oxygen, kBlue)};
}

}  // namespace sonoskin
