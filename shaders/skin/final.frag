// The skin as the camera sees it: light that has spread, the narrowest Gaussian at the picture's own resolution, and the
// surface's reflection.                                                                         [theory/skin.md, 9.2]
// Variants: KIND, see lights.glsl; DETAIL: layers of pores and lines; LINEAR: display-linear output for the resolve pass;
// LOBES: of the surface's reflection; WET: a film of water lies on it;
// PASS: 0 skin, 1 without spreading, 2 spread light alone, 3 reflection alone.
#include "common/colour.glsl"
#include "common/noise.glsl"
#include "common/occlusion.glsl"
#include "common/screen.glsl"
#include "skin/detail.glsl"
#include "skin/lights.glsl"
#include "skin/reflection.glsl"
#include "surface/buffer.glsl"

in vec2 uv;

uniform sampler2D surfaceMap, placeMap, depthMap;
uniform ivec2 toSurface;       // from a pixel that is drawn to that of the surface
uniform sampler2D diffusedMap, visibilityMap, albedoMap, finishMap;
uniform float detail;          // factor
uniform float pixelLength;     // mm per pixel and mm of distance
uniform float mixBefore, exposure;
uniform float unseenShade;     // 0 to 1: how far what was not measured is greyed
uniform vec3 firstWeight;      // of the narrowest Gaussian; 0 where the map holds it
uniform vec3 insideColour;     // of the inner sides of an open surface: nothing was measured there

layout(location = 0) out vec4 colour;

vec3 shade(vec3 p, vec3 smoothNormal, vec2 place, bool inner) {
  vec4 spread = textureLod(diffusedMap, place, 0.0), visibility = textureLod(visibilityMap, place, 0.0);
  vec3 albedo = max(textureLod(albedoMap, place, 0.0).rgb, vec3(0.02));
  vec4 finish = textureLod(finishMap, place, 0.0);
  spread.rgb /= max(spread.a, 1e-4);
  vec3 toEye = normalize(eye - p);
  float m = finish.r, facing = max(dot(smoothNormal, toEye), 0.05);
  float pixel = pixelLength * distance(eye, p) / facing;
  vec3 n = bumped(smoothNormal, p, pixel, detail * (1.0 - 0.7 * finish.a) * (1.0 - 0.5 * finish.b), m);
  float nv = max(dot(n, toEye), 0.02);
  vec2 kept = 1.0 - finish.g * reflected(nv, finish.r);  // by the surface, toward the eye and on average
  vec3 first = reflectedOcclusion(visibility.a, albedo) * irradianceAround(n) * kept.y;
  vec3 mirrored = vec3(0.0), coat = vec3(0.0);
#if defined(WET)
  const float coatF0 = 0.02, coatRoughness = 0.12;
  vec3 film = normalize(n + 0.6 * smoothNormal);  // fills the pores
#endif
  for (int i = 0; i < 3; ++i) {
    vec3 l = toLight(i, p), light = arriving(i, p) * visibility[i];
    float cosine = dot(n, l);
    first += light * max(cosine, 0.0) * (1.0 - finish.g * reflected(cosine, finish.r).x);
#if LOBES == 2
    mirrored += light * finish.g * (0.85 * lobe(n, toEye, l, m, f0) + 0.15 * lobe(n, toEye, l, 0.5 * m, f0));
#else
    mirrored += light * finish.g * lobe(n, toEye, l, 0.9 * m, f0);
#endif
#if defined(WET)
    coat += light * lobe(film, toEye, l, coatRoughness, coatF0);
#endif
  }
  vec3 around = radiance(reflect(-toEye, n)) * visibility.a * visibility.a;
  mirrored += finish.g * reflected(nv, m).x * around;
#if defined(WET)
  coat += schlick(coatF0, nv) * around;
  mirrored = mirrored * (1.0 - finish.b * schlick(coatF0, nv)) + finish.b * coat;
#endif
  vec3 before = pow(albedo, vec3(mixBefore));
  first *= before;
#if PASS == 1
  vec3 entered = first;
#else
  vec3 entered = firstWeight * first + spread.rgb;
#endif
  vec3 diffuse = albedo / before * entered * kept.x / kept.y;
#if PASS == 2
  vec3 sum = diffuse;
#elif PASS == 3
  vec3 sum = mirrored;
#else
  vec3 sum = diffuse + mirrored;
#endif
  return inner ? insideColour * (0.55 + 0.45 * facing) : sum;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy) + toSurface;
  float depth = texelFetch(depthMap, texel, 0).r;
  if (depth == 1.0) discard;  // the background is there already
  vec4 surface = texelFetch(surfaceMap, texel, 0);
  vec3 p = eye + distanceOf(depth) * rayAt(uv);
  vec3 light = shade(p, normalize(surface.xyz), texelFetch(placeMap, texel, 0).rg, isInner(surface.w));
  float unmeasured = unseenShade * (2.0 - 2.0 * abs(surface.w));
  light = mix(light, dot(light, vec3(0.2126, 0.7152, 0.0722)) * vec3(0.8, 0.85, 0.95), unmeasured);
  vec3 shown = toneMap(exposure * light);
#if defined(LINEAR)
  colour = vec4(shown, 1.0);
#else
  colour = vec4(toSrgb(shown) + (pixelNoise(gl_FragCoord.xy) - 0.5) / 255.0, 1.0);
#endif
}
