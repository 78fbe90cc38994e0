#include "core/skin/skin_presets.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "core/base/error.h"
#include "core/skin/chromophores.h"
#include "core/skin/scatter_profile.h"

namespace sonoskin {
namespace {

void takePigments(const Pigments& pigments, SkinOptions& skin) {
  skin.melanin = pigments.melanin;
  skin.blood = pigments.blood;
  skin.oxygen = pigments.oxygen;
  skin.epidermis = pigments.epidermis;
}

// Skin of that profile, in its own colour.
void takeProfile(ScatterProfile profile, SkinOptions& skin) {
  skin.profile = profile;
  takePigments(*pigmentsOf(profile), skin);
}

void firstHours(SkinOptions& skin, LightOptions&) {
  skin.blood = 0.025;
  skin.oxygen = 0.70;
  skin.mottling = 0.35;
  skin.vernix = 0.15;
  skin.wetness = 0.4;
}

void preterm(SkinOptions& skin, LightOptions&) {
  takeProfile(ScatterProfile::preterm, skin);
  skin.mottling = 0.4;
  skin.wetness = 0.3;
  skin.detail = 0.6;
  skin.translucency = 1.3;
}

void darker(SkinOptions& skin, LightOptions&) { takeProfile(ScatterProfile::darker, skin); }

void vernix(SkinOptions& skin, LightOptions&) {
  skin.profile = ScatterProfile::vernix;
  skin.vernix = 0.7;
  skin.wetness = 0.35;
}

void wet(SkinOptions& skin, LightOptions&) {
  skin.wetness = 0.9;
  skin.gloss = 0.5;
  skin.roughness = 0.25;
}

// One warm lamp in the dark, in front, above and to the left, and what a white wall on the other side gives back of it.
void loneLamp(LightOptions& light) {
  light.kind = LightKind::near;
  light.azimuth = -32;
  light.warmth = 3300;
  light.fill = 0.34;
  light.rim = 0.1;
  light.surround = 0.14;
  light.exposure = 0.35;
}

void clinic(SkinOptions& skin, LightOptions& light) {
  skin.colour = SkinColour::amber;
  skin.flush = 0;
  skin.mottling = 0;
  skin.wetness = 0.1;
  skin.gloss = 0.25;
  loneLamp(light);
  light.warmth = 5000;  // the warmth is the colour's
}

void live(SkinOptions& skin, LightOptions& light) {
  skin.blood = 0.025;
  skin.oxygen = 0.70;
  loneLamp(light);
}

void backLight(SkinOptions& skin, LightOptions& light) {
  skin.translucency = 1.5;
  light.kind = LightKind::near;
  light.azimuth = 150;
  light.elevation = 20;
  light.strength = 2;
  light.warmth = 3600;
  light.fill = 0.1;
  light.rim = 0;
  light.surround = 0.08;
}

void glow(SkinOptions& skin, LightOptions& light) {
  skin.translucency = 1.5;
  light.kind = LightKind::inside;
  light.distance = 0;
  light.strength = 9;
  light.warmth = 3000;
  light.fill = 0.05;
  light.rim = 0.2;
  light.surround = 0.08;
}

// Matter without pores, blood or water.
void lifeless(SkinOptions& skin) {
  skin.flush = 0;
  skin.mottling = 0;
  skin.wetness = 0;
  skin.detail = 0;
}

void clay(SkinOptions& skin, LightOptions&) {
  lifeless(skin);
  skin.colour = SkinColour::clay;
  skin.width = 0;
  skin.gloss = 0.1;
  skin.roughness = 0.5;
  skin.translucency = 0;
}

// The coefficients of marble of Jensen et al. 2001.
void marble(SkinOptions& skin, LightOptions& light) {
  lifeless(skin);
  skin.colour = SkinColour::plain;
  skin.profile = ScatterProfile::custom;
  skin.absorption = {0.0021, 0.0041, 0.0071};
  skin.scattering = {2.19, 2.62, 3.00};
  skin.gloss = 0.6;
  skin.roughness = 0.15;
  light.strength = 0.8;  // white needs no more
  light.surround = 0.15;
  light.exposure = -0.4;
}

constexpr std::array kPresets{
    SkinPreset{"newborn", "a newborn at term with light skin, under a soft lamp",
               [](SkinOptions&, LightOptions&) {}},
    SkinPreset{"first-hours", "red and mottled, still moist, as in the first hours of life", firstHours},
    SkinPreset{"preterm", "thin, red and translucent skin, as of a child born ten weeks early", preterm},
    SkinPreset{"darker", "a newborn with more melanin, which is still far from its later amount", darker},
    SkinPreset{"vernix", "under the white film that protects the skin before birth", vernix},
    SkinPreset{"wet", "as in the womb: a film of water all over", wet},
    SkinPreset{"clinic", "the amber of scanners under their one lamp", clinic},
    SkinPreset{"live",
               "the live modes of scanners: flushed skin, one warm lamp in the dark; not a true colour",
               live},
    SkinPreset{"back-light", "a lamp behind the head that shines through nose and ears", backLight},
    SkinPreset{"glow", "a lamp inside the body", glow},
    SkinPreset{"clay", "warm grey clay: light stays at the surface, nothing hides the shape", clay},
    SkinPreset{"marble", "a polished bust of white marble", marble}};

}  // namespace

std::span<const SkinPreset> skinPresets() { return kPresets; }

const SkinPreset& findSkinPreset(std::string_view name) {
  std::string names;
  for (const SkinPreset& preset : kPresets) {
    if (preset.name == name) return preset;
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", preset.name);
  }
  throw Error(fmt::format("there is no look \"{}\"; choose one of {}", name, names), Error::Kind::usage);
}

void applySkinPreset(const SkinPreset& preset, SkinOptions& skin, LightOptions& light) {
  skin = {};
  light = {};
  preset.change(skin, light);
}

const SkinPreset* matchingSkinPreset(const SkinOptions& skin, const LightOptions& light) {
  for (const SkinPreset& preset : kPresets) {
    SkinOptions candidate;
    LightOptions candidateLight;
    applySkinPreset(preset, candidate, candidateLight);
    if (candidate == skin && candidateLight == light) return &preset;
  }
  return nullptr;
}

}  // namespace sonoskin
