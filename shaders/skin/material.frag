// What the skin is made of at every texel of the atlas: colour, roughness, gloss, wetness, vernix.
// Functions of the place in mm and of the surface's shape alone.                      [skin specification, section 12]
#include "skin/noise3d.glsl"

uniform sampler2D positionMap, normalMap, openMap;
uniform sampler3D pigments;     // albedo over melanin, blood (both logarithmic), oxygen
uniform vec2 melaninRange, bloodRange;
uniform float melanin, blood, oxygen, flush, mottling, vernix, wetness, gloss, roughness;
uniform vec3 vernixAlbedo;
uniform float painted;          // 1 where pigments count; 0: one colour
uniform vec3 rightEye, leftEye, noseTip, mouthRight, mouthLeft;
uniform float eyesSet, noseSet, mouthSet;

layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 finish;

// 1 at the middle, 0 from `radius` on, soft.
float spot(vec3 p, vec3 middle, float radius) {
  float r = distance(p, middle) / radius;
  return exp(-2.5 * r * r) * (1.0 - smoothstep(1.2, 1.6, r));
}

struct Regions {
  float lips, lids, flushed;
};

// The face's parts from its landmarks; without them, what sticks out is flushed.
Regions regions(vec3 p, float convex) {
  Regions r = Regions(0.0, 0.0, 0.0);
  if (mouthSet > 0.0) {
    vec3 middle = 0.5 * (mouthRight + mouthLeft), across = 0.5 * (mouthLeft - mouthRight);
    float halfWidth = max(length(across), 1.0);
    vec3 side = across / halfWidth;
    vec3 away = p - middle;
    float along = dot(away, side) / (1.08 * halfWidth);
    float over = length(away - dot(away, side) * side) / (0.52 * halfWidth);
    // A hand before the mouth is no lip.
    float before = 0.0;
    if (eyesSet > 0.0) {
      vec3 upward = 0.5 * (rightEye + leftEye) - middle;
      vec3 forward = normalize(cross(side, upward));
      if (noseSet > 0.0 && dot(noseTip - middle, forward) < 0.0) forward = -forward;
      before = smoothstep(0.35, 0.6, dot(away, forward) / halfWidth);
    }
    // Lips narrow toward the corners; their line wavers a little.
    float edge = over / max(1.0 - along * along, 0.05) + 0.15 * noise(p / 1.7);
    r.lips = abs(along) < 1.0 ? (1.0 - smoothstep(0.75, 1.15, edge)) * (1.0 - before) : 0.0;
  }
  if (eyesSet > 0.0) {
    float apart = distance(rightEye, leftEye), lid = 0.27 * apart;
    r.lids = max(spot(p, rightEye, lid), spot(p, leftEye, lid));
    if (mouthSet > 0.0) {
      vec3 mouth = 0.5 * (mouthRight + mouthLeft), eyes = 0.5 * (rightEye + leftEye);
      vec3 right = mix(rightEye, mouth, 0.52) + 0.30 * (rightEye - eyes);
      vec3 left = mix(leftEye, mouth, 0.52) + 0.30 * (leftEye - eyes);
      r.flushed = max(spot(p, right, 0.42 * apart), spot(p, left, 0.42 * apart));
    }
    if (noseSet > 0.0) r.flushed = max(r.flushed, 0.8 * spot(p, noseTip, 0.25 * apart));
  }
  r.flushed = max(r.flushed, 0.45 * smoothstep(0.05, 0.28, convex));
  return r;
}

float onAxis(float value, vec2 range, int size) {
  float t = clamp(log(value / range.x) / log(range.y / range.x), 0.0, 1.0);
  return (t * float(size - 1) + 0.5) / float(size);
}

vec3 pigmentColour(float c, float h, float s) {
  ivec3 size = textureSize(pigments, 0);
  float z = (clamp(s, 0.0, 1.0) * float(size.z - 1) + 0.5) / float(size.z);
  return textureLod(pigments, vec3(onAxis(c, melaninRange, size.x), onAxis(h, bloodRange, size.y), z), 0.0).rgb;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 placed = texelFetch(positionMap, texel, 0);
  albedo = finish = vec4(0.0);
  if (placed.w == 0.0) return;
  vec3 p = placed.xyz;
  float convex = texelFetch(normalMap, texel, 0).w, open = texelFetch(openMap, texel, 0).w;
  Regions r = regions(p, convex);

  float patches = fractal(p, 13.0), wide = fractal(p + 100.0, 42.0);
  float net = 1.0 - abs(fractal(p + 200.0, 8.0)) * 2.2;  // a marbled net: cutis marmorata
  float h = blood * (1.0 + mottling * (0.9 * patches + 0.9 * clamp(net, -0.3, 1.0)) + 0.06 * noise(p / 1.1));
  h *= 1.0 + flush * 2.0 * r.flushed;
  h = mix(h, max(0.055, 3.0 * blood), flush * r.lips);
  float s = mix(oxygen, oxygen - 0.3, flush * r.lids);
  h *= 1.0 + 0.6 * flush * r.lids;
  float c = melanin * (1.0 + 0.35 * mottling * wide) * (1.0 + 0.1 * noise(p / 0.8));
  c = mix(c, 0.5 * c, flush * r.lips);
  vec3 colour = pigmentColour(mix(melanin, c, painted), mix(blood, h, painted), mix(oxygen, s, painted));

  // The film lies in hollows first and comes in flakes.
  float hollow = clamp(1.3 * (1.0 - open) - 2.0 * convex, -0.3, 1.0);
  float cover = 1.6 * vernix - 0.8 + 0.7 * hollow + 0.45 * fractal(p + 300.0, 14.0) + 0.3 * fractal(p + 600.0, 3.0);
  float film = vernix <= 0.0 ? 0.0 : smoothstep(-0.25, 0.75, cover);
  colour = mix(colour, vernixAlbedo, 0.8 * film);

  float oil = 0.15 * fractal(p + 400.0, 5.0) - 0.6 * clamp(convex, 0.0, 0.15);
  float m = clamp(roughness * (1.0 + oil), 0.08, 0.6);
  float wet = wetness * clamp(0.55 + 0.9 * hollow + 0.45 * fractal(p + 500.0, 6.0) + 0.6 * r.lips, 0.0, 1.0);
  albedo = vec4(colour, 1.0);
  finish = vec4(mix(m, 0.5, film), gloss * mix(1.0, 0.6, film), wet * (1.0 - 0.7 * film), film);
}
