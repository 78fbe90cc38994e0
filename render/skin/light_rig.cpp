#include "render/skin/light_rig.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

// The lightest colour of a black body: linear Rec. 709 with luminance 1, white at 6500 K.
//   solves   CIE 1960 u, v of Planck's locus                                      [Krystek 1985]
glm::vec3 colourOfHeat(double kelvin) {
  const auto unscaled = [](double t) {
    const double u = (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) /
                     (1 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
    const double v = (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) /
                     (1 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
    const double x = 3 * u / (2 * u - 8 * v + 4), y = 2 * v / (2 * u - 8 * v + 4);
    const double X = x / y, Z = (1 - x - y) / y;
    return glm::dvec3(3.2406 * X - 1.5372 - 0.4986 * Z, -0.9689 * X + 1.8758 + 0.0415 * Z,
                      0.0557 * X - 0.2040 + 1.0570 * Z);
  };
  const glm::dvec3 colour = glm::max(unscaled(kelvin) / unscaled(6500), 0.0);
  return glm::vec3(colour / glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722)));
}

// A sky that is brightest along `up`: order 1 of the spherical harmonics holds it exactly.
std::array<glm::vec3, 9> skyAndGround(const glm::vec3& sky, const glm::vec3& ground, const glm::vec3& up) {
  constexpr float kY0 = 0.282095f, kY1 = 0.488603f;
  std::array<glm::vec3, 9> c{};
  c[0] = 0.5f * (sky + ground) / kY0;
  const glm::vec3 slope = 0.5f * (sky - ground) / kY1;
  c[1] = slope * up.y;
  c[2] = slope * up.z;
  c[3] = slope * up.x;
  return c;
}

glm::vec3 direction(const HomeFrame& home, double azimuth, double elevation) {
  const double a = glm::radians(azimuth), e = glm::radians(elevation);
  return glm::normalize(float(std::cos(e) * std::sin(a)) * home.right + float(std::sin(e)) * home.up +
                        float(std::cos(e) * std::cos(a)) * home.back);
}

}  // namespace

HomeFrame homeFrame(const Camera& camera) { return {camera.right(), camera.up, -camera.forward}; }

glm::vec3 lightPlace(const LightOptions& options, const HomeFrame& home) {
  return direction(home, options.azimuth, options.elevation);
}

glm::vec2 lightAngles(const glm::vec3& d, const HomeFrame& home) {
  const float up = glm::clamp(glm::dot(d, home.up), -1.f, 1.f);
  return glm::degrees(glm::vec2(std::atan2(glm::dot(d, home.right), glm::dot(d, home.back)), std::asin(up)));
}

LightRig makeLightRig(const LightOptions& o, const HomeFrame& home, const Box& box) {
  LightRig rig;
  rig.exposure = std::exp2(float(o.exposure));
  const float radius = 0.5f * box.diagonal(), softness = std::tan(glm::radians(float(o.softness)));
  const float away = float(o.distance / kLightSize) * box.diagonal();
  SkinLight key;
  key.kind = o.kind;
  key.colour = float(o.strength) * colourOfHeat(o.warmth);
  key.softness = softness;
  key.shadows = o.shadows && o.kind != LightKind::inside;
  key.position = lightPlace(o, home);
  if (o.kind != LightKind::far) {
    const float limit = o.kind == LightKind::inside ? 0.5f * radius : 1e6f;  // in the body it stays
    key.position = box.centre() + std::min(away, limit) * key.position;
    // Where the lamp stands its strength holds at the middle of the surface, but not closer than a third of its radius.
    key.reach = std::max(away, 0.35f * radius);
  }
  // A room takes on its lamp's colour: what is in shadow looks shaded then, not grey or blue like a bruise.
  const glm::vec3 warm = colourOfHeat(o.warmth);
  const double side = o.azimuth <= 0 ? 1 : -1;
  SkinLight fill{.position = direction(home, side * 55, 5),
                 .colour = float(o.fill) * glm::mix(glm::vec3(1.02f, 0.99f, 0.99f), warm, 0.8f)};
  fill.shadows = false;  // a large soft light: what is closed in gets less of it
  SkinLight rim{.position = direction(home, side * 140, 32),
                .colour = float(o.rim) * glm::vec3(1.0f, 0.98f, 0.95f)};
  rim.softness = softness;
  rim.shadows = o.shadows;
  rig.lights = {key, fill, rim};
  const glm::vec3 around = float(o.surround) * glm::mix(glm::vec3(1), warm, 0.6f);
  rig.environment =
      skyAndGround(around * glm::vec3(1.03f, 1.0f, 1.0f), 0.4f * around * glm::vec3(1.12f, 0.97f, 0.92f),
                   glm::normalize(home.up + 0.45f * home.back));
  return rig;
}

}  // namespace sonoskin
