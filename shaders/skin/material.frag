// What the skin is made of at every texel of the atlas: colour, roughness, gloss, wetness, vernix.
// Functions of the place in mm and of the surface's shape alone.                                [theory/skin.md, 10.2]
#include "skin/noise3d.glsl"

uniform sampler2D positionMap, normalMap, openMap;  // AtlasMaps                                     [theory/skin.md, 3.3]
uniform sampler3D pigments;     // albedo over melanin, blood (both logarithmic), oxygen          [theory/skin.md, 10.1]
uniform vec2 melaninRange, bloodRange;  // shares at the table's ends: PigmentTable in core/skin/skin_material.h
// Of SkinOptions: C_m, C_h and S [Jacques 1998; Donner, Jensen 2006]; rho_s and m [Kelemen, Szirmay-Kalos 2001]; flush,
// mottling, vernix and wetness go from 0 to 1 and are ours.
uniform float melanin, blood, oxygen, flush, mottling, vernix, wetness, gloss, roughness;
uniform vec3 vernixAlbedo;      // the look "vernix", rounded                                     [theory/skin.md, 12.7]
uniform float painted;          // 1 where pigments count; 0: one colour
uniform vec3 rightEye, leftEye, noseTip, mouthRight, mouthLeft;  // LandmarkOptions, mm
uniform float eyesSet, noseSet, mouthSet;  // 1 where all of their landmarks are placed

layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 finish;

// 1 at the middle, 0 from 1.6 `radius` on, soft. Its shape was chosen by eye.
float spot(vec3 p, vec3 middle, float radius) {
  float r = distance(p, middle) / radius;
  return exp(-2.5 * r * r) * (1.0 - smoothstep(1.2, 1.6, r));
}

// Regions: shares, 0 to 1. flushed: cheeks and the tip of the nose.
struct Regions {
  float lips, lids, flushed;
};

// The face's parts from its landmarks; without them, what sticks out is flushed. All numbers were chosen by eye:
// sizes are shares of half the mouth's width or of the distance between the eyes.
Regions regions(vec3 p, float convex) {
  Regions r = Regions(0.0, 0.0, 0.0);
  if (mouthSet > 0.0) {
    vec3 middle = 0.5 * (mouthRight + mouthLeft), across = 0.5 * (mouthLeft - mouthRight);
    float halfWidth = max(length(across), 1.0);  // mm; at least so much, lest landmarks in one place divide by 0
    vec3 side = across / halfWidth;
    vec3 away = p - middle;
    float along = dot(away, side) / (1.08 * halfWidth);  // by eye: lips end a little beyond the corners
    float over = length(away - dot(away, side) * side) / (0.52 * halfWidth);  // by eye: half their height
    // A hand before the mouth is no lip.
    float before = 0.0;
    if (eyesSet > 0.0) {
      vec3 upward = 0.5 * (rightEye + leftEye) - middle;
      vec3 forward = normalize(cross(side, upward));
      if (noseSet > 0.0 && dot(noseTip - middle, forward) < 0.0) forward = -forward;
      before = smoothstep(0.35, 0.6, dot(away, forward) / halfWidth);  // by eye
    }
    // Lips narrow toward the corners; their line wavers a little.
    float edge = over / max(1.0 - along * along, 0.05) + 0.15 * noise(p / 1.7);  // by eye: wavers over 1.7 mm
    r.lips = abs(along) < 1.0 ? (1.0 - smoothstep(0.75, 1.15, edge)) * (1.0 - before) : 0.0;
  }
  if (eyesSet > 0.0) {
    float apart = distance(rightEye, leftEye), lid = 0.27 * apart;  // by eye
    r.lids = max(spot(p, rightEye, lid), spot(p, leftEye, lid));
    if (mouthSet > 0.0) {
      vec3 mouth = 0.5 * (mouthRight + mouthLeft), eyes = 0.5 * (rightEye + leftEye);
      // By eye: cheeks lie half the way down to the mouth and farther out than the eyes.
      vec3 right = mix(rightEye, mouth, 0.52) + 0.30 * (rightEye - eyes);
      vec3 left = mix(leftEye, mouth, 0.52) + 0.30 * (leftEye - eyes);
      r.flushed = max(spot(p, right, 0.42 * apart), spot(p, left, 0.42 * apart));
    }
    if (noseSet > 0.0) r.flushed = max(r.flushed, 0.8 * spot(p, noseTip, 0.25 * apart));  // by eye
  }
  r.flushed = max(r.flushed, 0.45 * smoothstep(0.05, 0.28, convex));  // by eye; mean curvature, 1/mm
  return r;
}

// Where the table holds a value: PigmentTable's logarithmic axes, looked up at the middles of texels.
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

  // Periods of mm by eye: 8 to 20 for blood, 30 to 60 for melanin; what is added to p only makes noises differ.
  float patches = fractal(p, 13.0), wide = fractal(p + 100.0, 42.0);
  float net = 1.0 - abs(fractal(p + 200.0, 8.0)) * 2.2;  // a marbled net: cutis marmorata; by eye, meshes of 6 to 10 mm
  // Strengths by eye.
  float h = blood * (1.0 + mottling * (0.9 * patches + 0.9 * clamp(net, -0.3, 1.0)) + 0.06 * noise(p / 1.1));
  h *= 1.0 + flush * 2.0 * r.flushed;  // three times the blood: the look "cheek" beside "newborn"  [theory/skin.md, 12.7]
  h = mix(h, max(0.055, 3.0 * blood), flush * r.lips);  // by eye, below the look "lip" (0.07)      [theory/skin.md, 12.7]
  float s = mix(oxygen, oxygen - 0.3, flush * r.lids);  // by eye, toward the look "lid" (0.45)     [theory/skin.md, 12.7]
  h *= 1.0 + 0.6 * flush * r.lids;                      // by eye, toward the look "lid" (twice)
  // Strengths by eye; lips have about half the melanin: the look "lip".                          [theory/skin.md, 12.7]
  float c = melanin * (1.0 + 0.35 * mottling * wide) * (1.0 + 0.1 * noise(p / 0.8));
  c = mix(c, 0.5 * c, flush * r.lips);
  vec3 colour = pigmentColour(mix(melanin, c, painted), mix(blood, h, painted), mix(oxygen, s, painted));

  // The film lies in hollows first and comes in flakes of 14 and 3 mm. All numbers by eye.
  float hollow = clamp(1.3 * (1.0 - open) - 2.0 * convex, -0.3, 1.0);
  float cover = 1.6 * vernix - 0.8 + 0.7 * hollow + 0.45 * fractal(p + 300.0, 14.0) + 0.3 * fractal(p + 600.0, 3.0);
  float film = vernix <= 0.0 ? 0.0 : smoothstep(-0.25, 0.75, cover);
  colour = mix(colour, vernixAlbedo, 0.8 * film);

  // Oil makes what sticks out smoother, over 5 mm; water stays in hollows and on lips. All numbers by eye.
  float oil = 0.15 * fractal(p + 400.0, 5.0) - 0.6 * clamp(convex, 0.0, 0.15);
  float m = clamp(roughness * (1.0 + oil), 0.08, 0.6);  // by eye, within SpecularTable
  float wet = wetness * clamp(0.55 + 0.9 * hollow + 0.45 * fractal(p + 500.0, 6.0) + 0.6 * r.lips, 0.0, 1.0);
  albedo = vec4(colour, 1.0);
  // A film is dull: roughness 0.5, 0.6 of the gloss, 0.3 of the water, by eye.
  finish = vec4(mix(m, 0.5, film), gloss * mix(1.0, 0.6, film), wet * (1.0 - 0.7 * film), film);
}
