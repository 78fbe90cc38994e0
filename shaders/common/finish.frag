// The last pass: from scene-linear samples to an sRGB picture. Variants: SURFACE (alpha is the share of the colour
// that occlusion may take away; negative alpha is background), or VOLUME (premultiplied colour, alpha is opacity).
#include "common/colour.glsl"
#include "common/noise.glsl"

in vec2 uv;

uniform sampler2D samples;
uniform int step;  // samples per pixel along one side
uniform vec3 backgroundTop, backgroundBottom;
uniform float exposure;

layout(location = 0) out vec4 colour;

#ifdef SURFACE
uniform sampler2D occlusionMap;

// The mean over 4x4 pixels, which is the noise's period, of those on the same surface.
float occlusion(ivec2 pixel) {
  vec2 here = texelFetch(occlusionMap, pixel, 0).xy;
  ivec2 last = textureSize(occlusionMap, 0) - 1;
  float sum = 0.0, weights = 0.0;
  for (int y = -2; y < 2; ++y)
    for (int x = -2; x < 2; ++x) {
      vec2 there = texelFetch(occlusionMap, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).xy;
      float weight = max(1.0 - abs(there.y - here.y) / (0.01 * here.y), 1e-3);
      sum += weight * there.x;
      weights += weight;
    }
  return sum / weights;
}
#endif

void main() {
  ivec2 pixel = ivec2(uv * vec2(textureSize(samples, 0)) / float(step));
  float height = uv.y + 0.25 * (uv.x - 0.5) * (uv.x - 0.5);
  vec3 background = mix(backgroundBottom, backgroundTop, smoothstep(0.0, 1.0, height));
#ifdef SURFACE
  float arriving = occlusion(pixel);
#endif
  vec3 sum = vec3(0.0);
  for (int y = 0; y < step; ++y)
    for (int x = 0; x < step; ++x) {
      vec4 s = texelFetch(samples, pixel * step + ivec2(x, y), 0);
#ifdef SURFACE
      vec3 shown = toneMap(exposure * s.rgb * (1.0 - s.a * (1.0 - arriving)));
      sum += s.a < 0.0 ? background : shown;
#else
      sum += toneMap(exposure * s.rgb) + (1.0 - s.a) * background;
#endif
    }
  float dither = (pixelNoise(gl_FragCoord.xy) - 0.5) / 255.0;
  colour = vec4(toSrgb(sum / float(step * step)) + dither, 1.0);
}
