// One of the maps on the surface, as a colour: the passes that people may look at.
// MAP: 0 linear light; 1 colour; 2 one value; 3 direction; 4 signed value; 5 millimetres per texel; 6 numbers of charts.
#include "common/colour.glsl"
#include "surface/buffer.glsl"

uniform sampler2D surfaceMap, placeMap, depthMap;
uniform ivec2 toSurface;       // from a pixel that is drawn to that of the surface
uniform sampler2D map;
uniform int channel;
uniform float scale;

layout(location = 0) out vec4 colour;

vec3 shownOf(vec4 value) {
#if MAP == 0
  return toneMap(scale * value.rgb / max(value.a, 1e-4));
#elif MAP == 1
  return value.rgb;
#elif MAP == 2
  float one = value[channel] * scale;
  return vec3(one * one);
#elif MAP == 3
  vec3 half_ = 0.5 + 0.5 * normalize(value.xyz + 1e-6);
  return half_ * half_;
#elif MAP == 4
  float x = clamp(value[channel] * scale, -1.0, 1.0);
  return x > 0.0 ? mix(vec3(0.5), vec3(0.75, 0.2, 0.1), x) : mix(vec3(0.5), vec3(0.1, 0.25, 0.7), -x);
#elif MAP == 5
  float x = clamp(log2(max(value.r, value.g) * scale), -1.0, 1.0);
  return x > 0.0 ? mix(vec3(0.5), vec3(0.8, 0.25, 0.1), x) : mix(vec3(0.5), vec3(0.1, 0.3, 0.8), -x);
#else
  float k = floor(value[channel] * scale + 0.5);
  vec3 hue = clamp(abs(fract(k * 0.61803 + vec3(0.0, 0.667, 0.333)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
  return 0.15 + 0.6 * hue;
#endif
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy) + toSurface;
  if (texelFetch(depthMap, texel, 0).r == 1.0) discard;  // the background is there already
  vec3 shown = shownOf(textureLod(map, texelFetch(placeMap, texel, 0).rg, 0.0));
  if (isInner(texelFetch(surfaceMap, texel, 0).w)) shown *= 0.35;
#if defined(LINEAR)
  colour = vec4(shown, 1.0);
#else
  colour = vec4(toSrgb(shown), 1.0);
#endif
}
