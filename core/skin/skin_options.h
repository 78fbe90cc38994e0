#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// SkinColour: where the surface's own colour comes from.
enum class SkinColour { pigments, amber, clay, plain };
constexpr std::array<const char*, 4> enumNames(SkinColour) { return {"pigments", "amber", "clay", "plain"}; }

// ScatterProfile: how light spreads below the surface. adult: the six Gaussians of d'Eon, Luebke and Enderton; newborn,
// preterm, darker and vernix: fitted to a dipole of their pigments; custom: fitted to `absorption` and `scattering`.
enum class ScatterProfile { adult, newborn, preterm, darker, vernix, custom };
constexpr std::array<const char*, 6> enumNames(ScatterProfile) {
  return {"adult", "newborn", "preterm", "darker", "vernix", "custom"};
}

// ThinModel: light through thin parts. slab: the transmittance of a plate (multipole); gaussians: the profile's own
// Gaussians at the depth's distance (the exact mode of GPU Gems 3), which is dark beyond 2 mm.
enum class ThinModel { slab, gaussians };
constexpr std::array<const char*, 2> enumNames(ThinModel) { return {"slab", "gaussians"}; }

// SkinOptions: what the skin is made of and how it looks. Nothing here changes the surface.
struct SkinOptions {
  SkinColour colour = SkinColour::pigments;
  double melanin = 0.005;
  double blood = 0.014;
  double oxygen = 0.85;
  double epidermis = 0.06;
  double flush = 0.5;
  double mottling = 0.15;
  double vernix = 0;
  double wetness = 0.2;
  ScatterProfile profile = ScatterProfile::adult;
  double width = 1;
  double mix = 0.5;
  std::array<double, 3> absorption{0.032, 0.17, 0.48};
  std::array<double, 3> scattering{0.74, 0.88, 1.01};
  int gaussians = 6;
  double gloss = 0.35;
  double roughness = 0.3;
  double detail = 1;
  ThinModel thinModel = ThinModel::slab;
  double translucency = 1;
  double density = 1;

  bool operator==(const SkinOptions&) const = default;
};

template <class F, class O>
requires OptionsOf<O, SkinOptions>
void fields(F&& f, O& o) {
  f(Field{"colour", "pigments: from melanin and blood; amber: the look of scanners; clay; plain: white"},
    o.colour);
  f(Field{"melanin", "share of the epidermis that is melanin", "", "C_m"}, o.melanin,
    Range{0.001, 0.2, true});
  f(Field{"blood", "share of the dermis that is blood", "", "C_h"}, o.blood, Range{0.001, 0.1, true});
  f(Field{"oxygen", "share of the blood's haemoglobin that carries oxygen", "", "S"}, o.oxygen,
    Range{0.0, 1.0});
  f(Field{"epidermis", "thickness of the outer layer, which holds the melanin", "mm", "t"}, o.epidermis,
    Range{0.01, 0.3, true});
  f(Field{"flush", "more blood in cheeks, lips, nose and ears, less oxygen in lids"}, o.flush,
    Range{0.0, 1.0});
  f(Field{"mottling", "uneven blood: large soft patches and a marbled net"}, o.mottling, Range{0.0, 1.0});
  f(Field{"vernix", "how much of the skin the white film of the newborn covers, creases first"}, o.vernix,
    Range{0.0, 1.0});
  f(Field{"wetness", "a film of water over the skin, hollows first"}, o.wetness, Range{0.0, 1.0});
  f(Field{"profile", "how light spreads below the surface; custom: by absorption and scattering"}, o.profile);
  f(Field{"width", "makes the spread wider or narrower; 0: light does not enter the skin", "times"}, o.width,
    Range{0.0, 4.0});
  f(Field{"mix", "how much of the colour light takes up before it spreads; the rest after", ""}, o.mix,
    Range{0.0, 1.0});
  f(Field{"absorption", "for profile = custom and the slab: red, green, blue", "1/mm", "sigma_a"},
    o.absorption, Range{0.0001, 20.0});
  f(Field{"scattering", "for profile = custom and the slab: red, green, blue", "1/mm", "sigma_s'"},
    o.scattering, Range{0.01, 50.0});
  f(Field{"gaussians", "for profile = custom: terms of the sum that is fitted", "terms", "k"}, o.gaussians,
    Range{1, 6});
  f(Field{"gloss", "strength of the surface's reflection; 1: that of an interface of index 1.4", "", "rho_s"},
    o.gloss, Range{0.0, 1.0});
  f(Field{"roughness", "slope of the surface below what is seen", "", "m"}, o.roughness, Range{0.1, 0.6});
  f(Field{"detail", "pores and fine lines; 0: smooth", "times"}, o.detail, Range{0.0, 3.0});
  f(Field{"thinModel", "light through thin parts: slab, or gaussians (opaque beyond 2 mm)"}, o.thinModel);
  f(Field{"translucency", "strength of light through thin parts", "times"}, o.translucency, Range{0.0, 4.0});
  f(Field{"density", "for a light inside the body: tissue it passes, as a share of the way to the skin",
          "times"},
    o.density, Range{0.05, 4.0});
}

}  // namespace sonoskin
