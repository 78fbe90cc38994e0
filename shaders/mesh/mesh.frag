// A lit surface, scene-linear. Variants: SKIN, or neutral clay.
#include "common/lighting.glsl"
#include "common/noise.glsl"

in vec3 worldPosition;
in vec3 worldNormal;
in vec3 shadowPosition;
in float seen;

uniform vec3 eye;
uniform sampler2DShadow shadowMap;
uniform float shadowRadius;  // of the penumbra, in shadow-map units
uniform float unseenShade;   // 0 to 1: how far regions that the probe cannot have seen are greyed

layout(location = 0) out vec4 colour;  // rgb, and the share of it that ambient occlusion may take away

float keyShadow() {
  const int taps = 8;
  float angle = 6.2831853 * pixelNoise(gl_FragCoord.xy);
  float light = 0.0;
  for (int i = 0; i < taps; ++i)
    light += texture(shadowMap, shadowPosition + vec3(shadowRadius * discPoint(i, taps, angle), 0.0));
  return light / float(taps);
}

void main() {
  vec3 normal = normalize(worldNormal) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 toEye = normalize(eye - worldPosition);
  float shadow = keyShadow();
  float edge = pow(1.0 - max(dot(normal, toEye), 0.0), 3.0);
#ifdef SKIN
  vec3 albedo = vec3(0.76, 0.48, 0.35);
  const vec3 wrap = vec3(0.42, 0.18, 0.12);        // red light travels farthest below the skin
  vec3 keyLight = pow(vec3(shadow), vec3(0.6, 0.95, 1.05));  // and so it reaches into shadows
  const float roughness = 0.46, f0 = 0.028, shine = 0.9;
#else
  vec3 albedo = vec3(0.60, 0.585, 0.56);
  const vec3 wrap = vec3(0.10);
  vec3 keyLight = vec3(shadow);
  const float roughness = 0.55, f0 = 0.04, shine = 0.6;
#endif
  albedo = mix(albedo, vec3(luminance(albedo)) * vec3(0.55, 0.6, 0.7), unseenShade * (1.0 - seen));
  vec3 key = keyColour * keyLight;
  vec3 direct = albedo * (key * wrapped(dot(normal, keyDirection), wrap) +
                          fillColour * wrapped(dot(normal, fillDirection), wrap));
  direct += shine * (key * specular(normal, toEye, keyDirection, roughness, f0) +
                     fillColour * specular(normal, toEye, fillDirection, roughness, f0));
  vec3 ambient = albedo * hemisphere(normal);
  ambient += albedo * rimColour * edge * (0.4 + 0.6 * max(dot(normal, rimDirection), 0.0));
  vec3 sum = direct + ambient;
  float share = mix(0.45, 1.0, luminance(ambient) / max(luminance(sum), 1e-6));
  if (!gl_FrontFacing) sum *= vec3(0.35, 0.33, 0.36);
  colour = vec4(sum, share);
}
