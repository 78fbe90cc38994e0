#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace sonoskin {

// toSrgb, fromSrgb: between linear and sRGB-encoded colours, 0 to 1 (IEC 61966-2-1); as shaders/common/colour.glsl.
inline glm::vec3 toSrgb(const glm::vec3& linear) {
  const auto encode = [](float c) {
    return c < 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
  };
  return {encode(linear.r), encode(linear.g), encode(linear.b)};
}
inline glm::vec3 fromSrgb(const glm::vec3& encoded) {
  const auto decode = [](float c) {
    return c < 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  };
  return {decode(encoded.r), decode(encoded.g), decode(encoded.b)};
}

}  // namespace sonoskin
