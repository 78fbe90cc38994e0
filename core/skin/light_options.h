#pragma once

#include <array>

#include "core/base/fields.h"

namespace sonoskin {

// LightKind: the movable light. far: parallel rays; near: a lamp at a distance; inside: a lamp within the body that
// shines through the skin.
enum class LightKind { far, near, inside };
constexpr std::array<const char*, 3> enumNames(LightKind) { return {"far", "near", "inside"}; }

// kLightSize: mm from corner to corner of the surface for which a lamp's distance counts as it is said: about what a scan
// of a head shows. The lamps of larger and smaller ones go along with them, so that they look the same.
constexpr double kLightSize = 160;

// LightOptions: the lights on the skin. Angles are those of the home view (the probe's side; for mesh files the front):
// 0 and 0 is the viewer's own place.
struct LightOptions {
  LightKind kind = LightKind::far;
  double azimuth = -38;
  double elevation = 38;
  double distance = 150;
  double strength = 1.15;
  double warmth = 5400;
  double softness = 9;
  double fill = 0.34;
  double rim = 0.4;
  double surround = 0.32;
  bool shadows = true;
  double exposure = 0.2;

  bool operator==(const LightOptions&) const = default;
};

template <class F, class O>
requires OptionsOf<O, LightOptions>
void fields(F&& f, O& o) {
  f(Field{"kind", "the movable light: far, near (a lamp) or inside the body"}, o.kind);
  f(Field{"azimuth", "where it is: to the viewer's right; beyond 90: behind", "degrees"}, o.azimuth,
    Range{-180.0, 180.0});
  f(Field{"elevation", "where it is: upward", "degrees"}, o.elevation, Range{-90.0, 90.0});
  f(Field{"distance",
          "for near and inside: from the middle of a surface 160 mm across; larger and smaller ones have it "
          "in proportion",
          "mm"},
    o.distance, Range{0.0, 1000.0});
  f(Field{"strength", "of the movable light; 1: a white surface that faces it is white", "times"}, o.strength,
    Range{0.0, 10.0});
  f(Field{"warmth", "colour temperature; low is warm, 6500 is white", "K"}, o.warmth, Range{1800.0, 12000.0});
  f(Field{"softness", "size of the light as the skin sees it: blur of the shadows' edges", "degrees"},
    o.softness, Range{0.0, 20.0});
  f(Field{"fill", "a soft second light from the other side", "times"}, o.fill, Range{0.0, 4.0});
  f(Field{"rim", "a third light from behind", "times"}, o.rim, Range{0.0, 4.0});
  f(Field{"surround", "light from all around, more from above", "times"}, o.surround, Range{0.0, 4.0});
  f(Field{"shadows", "whether the lights cast shadows"}, o.shadows);
  f(Field{"exposure", "brightness of the picture, in doublings", "EV"}, o.exposure, Range{-6.0, 6.0});
}

}  // namespace sonoskin
