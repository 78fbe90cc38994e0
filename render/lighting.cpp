#include "render/lighting.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/error.h"

namespace sonoskin {
namespace {

[[noreturn]] void refuse(std::string_view word) {
  throw Error(
      fmt::format("--light: \"{}\" is not known; use portrait, or azimuth=, elevation= (degrees from the "
                  "camera) and strength= (0 to 100)",
                  word),
      Error::Kind::usage);
}

// numberAfter: the number in "name=number", or nothing where the word is another.
std::optional<float> numberAfter(std::string_view name, std::string_view word) {
  if (!word.starts_with(name) || word.size() <= name.size() || word[name.size()] != '=') return std::nullopt;
  const std::string_view number = word.substr(name.size() + 1);
  float value = 0;
  const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (failure != std::errc() || end != number.data() + number.size() || !std::isfinite(value)) refuse(word);
  return value;
}

}  // namespace

Lighting portraitLighting(const Camera& camera) {
  const glm::vec3 right = camera.right(), up = camera.up, toEye = -camera.forward;
  Lighting l;
  l.key = {glm::normalize(-0.62f * right + 0.66f * up + 0.62f * toEye), {1.30f, 1.22f, 1.10f}};
  l.fill = {glm::normalize(0.85f * right + 0.05f * up + 0.60f * toEye), {0.24f, 0.225f, 0.22f}};
  l.rim = {glm::normalize(0.55f * right + 0.60f * up - 0.60f * toEye), {0.52f, 0.52f, 0.55f}};
  l.sky = {0.29f, 0.285f, 0.285f};
  l.ground = {0.16f, 0.125f, 0.105f};
  l.skyDirection = glm::normalize(up + 0.4f * toEye);
  l.backgroundTop = {0.030f, 0.036f, 0.046f};
  l.backgroundBottom = {0.006f, 0.007f, 0.009f};
  return l;
}

Lighting parseLighting(std::string_view text, const Camera& camera) {
  Lighting lighting = portraitLighting(camera);
  if (text == "portrait") return lighting;
  // Where nothing is said the key light stays at the angles of the portrait.
  const glm::vec3 key = lighting.key.direction;
  float elevation = std::asin(glm::dot(key, camera.up));
  float azimuth = std::atan2(glm::dot(key, camera.right()), -glm::dot(key, camera.forward));
  while (!text.empty()) {
    const auto word = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (const auto degrees = numberAfter("azimuth", word))
      azimuth = glm::radians(*degrees);
    else if (const auto height = numberAfter("elevation", word))
      elevation = glm::radians(*height);
    else if (const auto factor = numberAfter("strength", word); factor && *factor >= 0 && *factor <= 100)
      lighting.key.colour *= *factor;
    else
      refuse(word);
  }
  const glm::vec3 level = std::sin(azimuth) * camera.right() - std::cos(azimuth) * camera.forward;
  lighting.key.direction = glm::normalize(std::cos(elevation) * level + std::sin(elevation) * camera.up);
  return lighting;
}

void setLights(gl::Program& program, const Lighting& l) {
  program.set("keyDirection", l.key.direction);
  program.set("keyColour", l.key.colour);
  program.set("fillDirection", l.fill.direction);
  program.set("fillColour", l.fill.colour);
  program.set("rimDirection", l.rim.direction);
  program.set("rimColour", l.rim.colour);
  program.set("skyColour", l.sky);
  program.set("groundColour", l.ground);
  program.set("skyDirection", l.skyDirection);
  program.set("backgroundTop", l.backgroundTop);
  program.set("backgroundBottom", l.backgroundBottom);
  program.set("backdrop", l.background ? 1.0f : 0.0f);
  program.set("exposure", l.exposure);
}

}  // namespace sonoskin
