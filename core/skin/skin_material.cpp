#include "core/skin/skin_material.h"

#include <algorithm>
#include <cmath>

#include "core/skin/chromophores.h"
#include "core/skin/multipole.h"
#include "core/skin/scatter_profile.h"

namespace sonoskin {
namespace {

constexpr glm::vec3 kAmber{0.72f, 0.40f, 0.19f}, kClay{0.57f, 0.55f, 0.52f}, kPlain{1.0f, 1.0f, 1.0f};

// Step i of n between two limits, even in the logarithm.
double logarithmicStep(double least, double most, int i, int n) {
  return least * std::pow(most / least, double(i) / (n - 1));
}

PigmentTable tableOfOneColour(const glm::vec3& colour) {
  PigmentTable table;
  table.albedo.assign(size_t(PigmentTable::kMelanin * PigmentTable::kBlood * PigmentTable::kOxygen), colour);
  return table;
}

// Light passes the epidermis twice.
std::vector<Spectrum> epidermisRows(double thickness) {
  std::vector<Spectrum> rows;
  for (int x = 0; x < PigmentTable::kMelanin; ++x) {
    const double melanin =
        logarithmicStep(PigmentTable::kLeastMelanin, PigmentTable::kMostMelanin, x, PigmentTable::kMelanin);
    rows.push_back(epidermisTransmittance(melanin, thickness));
    for (double& value : rows.back()) value *= value;
  }
  return rows;
}

PigmentTable tableOfPigments(double epidermis) {
  PigmentTable table;
  const std::vector<Spectrum> above = epidermisRows(epidermis);
  for (int z = 0; z < PigmentTable::kOxygen; ++z)
    for (int y = 0; y < PigmentTable::kBlood; ++y) {
      const double blood =
          logarithmicStep(PigmentTable::kLeastBlood, PigmentTable::kMostBlood, y, PigmentTable::kBlood);
      const Spectrum below = dermisReflectance(blood, double(z) / (PigmentTable::kOxygen - 1));
      for (const Spectrum& passed : above) {
        Spectrum reflectance;
        for (size_t i = 0; i < kWavelengths; ++i) reflectance[i] = passed[i] * below[i];
        table.albedo.push_back(glm::clamp(glm::vec3(linearColour(reflectance)), 0.0f, 1.0f));
      }
    }
  return table;
}

PigmentTable tableOf(const SkinOptions& options) {
  switch (options.colour) {
    case SkinColour::amber:
      return tableOfOneColour(kAmber);
    case SkinColour::clay:
      return tableOfOneColour(kClay);
    case SkinColour::plain:
      return tableOfOneColour(kPlain);
    case SkinColour::pigments:
      break;
  }
  return tableOfPigments(options.epidermis);
}

// The thinnest plate that the multipole describes: 1.55 mean free paths, and 1 mm at least.
double thinnestPlate(const MediumRgb& medium) {
  double path = 0;
  for (const ScatteringMedium& m : medium) path = std::max(path, makeDipole(m).real);
  return std::max(1.0, 1.55 * path);
}

std::vector<glm::vec3> transmittanceOf(const MediumRgb& medium) {
  const double thinnest = thinnestPlate(medium);
  std::vector<glm::vec3> table(SkinMaterial::kSteps);
  for (int i = 0; i < SkinMaterial::kSteps; ++i) {
    const double thickness = std::max(thinnest, SkinMaterial::kReach * i / (SkinMaterial::kSteps - 1));
    for (int c = 0; c < 3; ++c) {
      const ScatteringMedium& m = medium[size_t(c)];
      table[size_t(i)][c] = float(plateOf(m, thickness).transmittance / totalReflectance(makeDipole(m)));
    }
  }
  return table;
}

}  // namespace

SkinMaterial makeSkinMaterial(const SkinOptions& options) {
  SkinMaterial material;
  material.diffusion = diffusionOf(options);
  material.pigments = tableOf(options);
  material.transmittance = transmittanceOf(mediumOf(options));
  return material;
}

}  // namespace sonoskin
