#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/skin/gaussian_sum.h"
#include "core/skin/skin_options.h"

namespace sonoskin {

// PigmentTable: linear Rec. 709 albedo over melanin (x), blood (y), oxygen (z); x fastest. The axes of melanin and blood
// are logarithmic between their limits, oxygen is linear from 0 to 1.
struct PigmentTable {
  static constexpr int kMelanin = 32, kBlood = 32, kOxygen = 5;
  static constexpr double kLeastMelanin = 0.001, kMostMelanin = 0.2, kLeastBlood = 0.001, kMostBlood = 0.2;
  std::vector<glm::vec3> albedo;
};

// SkinMaterial: what the passes need of SkinOptions.
//   diffusion       scaled by the width; each channel's weights sum to 1
//   pigments        for the options' epidermis; amber and clay are tables of one colour
//   transmittance   of a plate of the material over thickness 0 .. kReach mm in equal steps, divided by the total diffuse
//                   reflectance: times the local albedo it is what comes out behind; below the formula's limit constant
//   vernix          albedo of the film
struct SkinMaterial {
  static constexpr int kSteps = 256;
  static constexpr double kReach = 40;
  GaussianSum diffusion;
  PigmentTable pigments;
  std::vector<glm::vec3> transmittance;
  glm::vec3 vernix{0.55f, 0.46f, 0.36f};
};

// makeSkinMaterial: the tables behind the options.
//   cost    below 50 ms
SkinMaterial makeSkinMaterial(const SkinOptions& options);

// SpecularTable: directional albedo of the surface's reflection, over cos (x, 0 .. 1) and roughness m (y, 0.05 .. 0.65),
// for rho_s = 1, F0 = 0.028.                                                    [Kelemen, Szirmay-Kalos 2001]
//   value     size kCosines * kRoughnesses, x fastest; mean: its cosine-weighted mean per roughness
struct SpecularTable {
  static constexpr int kCosines = 64, kRoughnesses = 32;
  static constexpr double kLeast = 0.05, kMost = 0.65;
  std::vector<float> value, mean;
};
const SpecularTable& specularTable();

}  // namespace sonoskin
