// From a surface buffer (several samples per pixel) to an sRGB picture. Pixels whose samples lie on one smooth piece of
// the surface are shaded once, the others once per sample.
// Variants: SKIN, AMBER, PARTS (w tells colours of parts), or neutral clay; SAMPLES (per pixel, along one side);
// OUTLINE (outlineMap counts more of them where the surface ends).
#include "common/colour.glsl"
#include "common/lighting.glsl"
#include "common/noise.glsl"
#include "common/occlusion.glsl"
#include "common/outline.glsl"
#include "common/screen.glsl"
#include "surface/buffer.glsl"
#if defined(PARTS)
#include "surface/part_colours.glsl"
#endif

in vec2 uv;

uniform sampler2D normalMap, depthMap;  // the surface buffer
uniform sampler2D occlusionMap;  // see surface/occlusion.frag
uniform float unseenShade;    // 0 to 1: how far regions that the probe cannot have seen are greyed
uniform float exposure;
uniform vec3 backgroundTop, backgroundBottom;
uniform float backdrop;       // 1 or 0: whether there is a background

layout(location = 0) out vec4 colour;

#if defined(SKIN)
const vec3 skinAlbedo = vec3(0.78, 0.475, 0.35);
const vec3 wrap = vec3(0.42, 0.18, 0.12);        // red light travels farthest below the skin
const vec3 shadowPower = vec3(0.55, 0.95, 1.05);  // and so it reaches into shadows
const float roughness = 0.44, f0 = 0.028, shine = 1.0;
#elif defined(AMBER)
const vec3 skinAlbedo = vec3(0.80, 0.45, 0.235);
const vec3 wrap = vec3(0.40, 0.20, 0.12), shadowPower = vec3(0.6, 0.95, 1.05);
const float roughness = 0.5, f0 = 0.03, shine = 0.8;
#else
const vec3 skinAlbedo = vec3(0.60, 0.585, 0.56);
const vec3 wrap = vec3(0.10), shadowPower = vec3(1.0);
const float roughness = 0.55, f0 = 0.04, shine = 0.6;
#endif

// Light from all around and of the key: the mean over 4x4 pixels, the noise's period, on the same surface.
vec2 arrivingLight(ivec2 pixel, int taps) {
  float here = texelFetch(occlusionMap, pixel, 0).y;
  ivec2 last = textureSize(occlusionMap, 0) - 1;
  vec2 sum = vec2(0.0);
  float weights = 0.0;
  for (int i = 0; i < taps; ++i) {
    vec3 there = texelFetch(occlusionMap, clamp(pixel + ivec2(i & 3, i >> 2) - 2, ivec2(0), last), 0).xyz;
    float weight = max(1.0 - abs(there.y - here) / (0.01 * here), 1e-3);
    sum += weight * there.xz;
    weights += weight;
  }
  return sum / max(weights, 1e-3);
}

vec3 shade(vec3 position, vec3 normal, float w, vec2 light) {
  float arriving = light.x;
  vec3 toEye = normalize(eye - position);
  bool inner = isInner(w);
  vec3 albedo = skinAlbedo;
#if defined(PARTS)
  albedo = partColour(knownOf(w));
#endif
  float unseen = unseenShade * (1.0 - (inner ? 1.0 : w));
  albedo = mix(albedo, vec3(luminance(albedo)) * vec3(0.55, 0.6, 0.7), unseen);
  vec3 key = keyColour * pow(vec3(light.y), shadowPower);
  vec3 fill = fillColour * mix(1.0, arriving, 0.6);
  vec3 sum = albedo * (key * wrapped(dot(normal, keyDirection), wrap) * mix(1.0, arriving, 0.3) +
                       fill * wrapped(dot(normal, fillDirection), wrap));
  sum += shine * (key * specular(normal, toEye, keyDirection, roughness, f0) +
                  fill * specular(normal, toEye, fillDirection, roughness, f0));
  float edge = pow(1.0 - max(dot(normal, toEye), 0.0), 3.0);
  vec3 around = hemisphere(normal) + rimColour * edge * (0.4 + 0.6 * max(dot(normal, rimDirection), 0.0));
#if defined(SKIN)
  around *= vec3(1.10, 0.97, 0.90);  // what entered elsewhere comes out red
#endif
  sum += albedo * around * reflectedOcclusion(arriving, albedo);
  return inner ? sum * vec3(0.35, 0.33, 0.36) : sum;
}

void main() {
  const int n = SAMPLES * SAMPLES;
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surfaces[n];
  float depths[n];
  vec4 meanSurface = vec4(0.0);
  float meanDepth = 0.0, least = 1.0, most = 0.0;
  bool oneColour = true;
  for (int i = 0; i < n; ++i) {
    ivec2 texel = pixel * SAMPLES + ivec2(i % SAMPLES, i / SAMPLES);
    depths[i] = texelFetch(depthMap, texel, 0).r;
    surfaces[i] = texelFetch(normalMap, texel, 0);
    surfaces[i].xyz *= inversesqrt(max(dot(surfaces[i].xyz, surfaces[i].xyz), 1e-12));
    meanSurface += surfaces[i] / float(n);
#if defined(PARTS)
    oneColour = oneColour && surfaces[i].w == surfaces[0].w;
#endif
    meanDepth += depths[i] / float(n);
    least = min(least, depths[i]);
    most = max(most, depths[i]);
  }
  bool empty = least >= 1.0;
  bool smoothPiece = oneColour && most < 1.0 && dot(meanSurface.xyz, meanSurface.xyz) > 0.94 &&
                     distanceOf(most) - distanceOf(least) < 0.01 * distanceOf(least);
  float height = uv.y + 0.25 * (uv.x - 0.5) * (uv.x - 0.5);
  vec3 background = mix(backgroundBottom, backgroundTop, smoothstep(0.0, 1.0, height));
  int count = empty ? 0 : smoothPiece ? 1 : n;
  vec2 light = arrivingLight(pixel, empty ? 0 : 16);
  vec3 sum = vec3(0.0);
  float shaded = 0.0;
  for (int i = 0; i < count; ++i) {
    vec4 surface = smoothPiece ? meanSurface : surfaces[i];
    float depth = smoothPiece ? meanDepth : depths[i];
    vec3 position = eye + distanceOf(depth) * rayAt(uv);
    vec3 shown = toneMap(exposure * shade(position, normalize(surface.xyz), surface.w, light));
    sum += depth < 1.0 ? shown : vec3(0.0);
    shaded += depth < 1.0 ? 1.0 : 0.0;
  }
#if defined(OUTLINE)
  float covered = smoothPiece || empty ? shaded : coverage(pixel, SAMPLES);
#else
  float covered = shaded / float(max(count, 1));
#endif
  covered = shaded > 0.0 ? covered : 0.0;
  vec3 linear = mix(background, sum / max(shaded, 1.0), backdrop > 0.0 ? covered : 1.0);
  float dither = (pixelNoise(gl_FragCoord.xy) - 0.5) / 255.0;
  colour = vec4(toSrgb(linear) + dither, max(covered, backdrop));
}
