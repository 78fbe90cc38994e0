// sRGB transfer function (IEC 61966-2-1): linear [0,1] -> encoded [0,1].
vec3 toSrgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

// The other way.
vec3 fromSrgb(vec3 encoded) {
  return mix(encoded / 12.92, pow((encoded + 0.055) / 1.055, vec3(2.4)), step(0.04045, encoded));
}

// Scene-linear -> display-linear. Leaves everything below 0.76 as it is, so that albedos keep their colour, and
// compresses highlights toward white. [Khronos PBR Neutral tone mapper, without its Fresnel offset]
vec3 toneMap(vec3 colour) {
  const float start = 0.76, desaturation = 0.15;
  float peak = max(colour.r, max(colour.g, colour.b));
  float range = 1.0 - start;
  float newPeak = 1.0 - range * range / (max(peak, start) + range - start);
  vec3 compressed = colour * (newPeak / max(peak, 1e-6));
  float white = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
  return peak < start ? colour : mix(compressed, vec3(newPeak), white);
}
