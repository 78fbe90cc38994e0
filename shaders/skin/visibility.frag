// How much of one light reaches every texel of the atlas, and of light 0, how deep the skin is there as it sees it.
// Variants: LIGHT: its number; KIND, see lights.glsl; TAPS: looks into its depth map.             [theory/skin.md, 4.2, 7.1]
#include "common/noise.glsl"
#include "skin/entry.glsl"
#include "skin/lights.glsl"
#include "skin/maps.glsl"

uniform sampler2D depthMap, placeMap;
uniform sampler2D exitMap;  // depths where light first leaves the body
uniform float density;      // of tissue before a light inside

// Drawn into the channel of the light alone.
layout(location = 0) out vec4 visibility;  // a: open sky
layout(location = 1) out vec4 thin;        // exp(-k depth); a: coverage; premultiplied

const float kThickness = 0.2;  // 1/mm
const float kNothing = 50.0;   // mm: as good as opaque
const float kSearch = 0.075;   // of the map's side: how far before the surface something in the way is looked for
const int kLooks = TAPS < 16 ? 4 : 8;  // for what stands in the way, and for depth

vec3 inMap(vec3 p) {
  vec4 place = lights[LIGHT].toMap * vec4(p, 1.0);
  return place.xyz / place.w;
}

// Share of the four texels around a place that are not nearer than `distance`, weighted by their overlap.
float passes(vec2 place, float distance) {
  vec2 size = vec2(textureSize(depthMap, 0)), texel = place * size - 0.5, part = fract(texel);
  vec4 found = textureGather(depthMap, (floor(texel) + 1.0) / size);
  vec4 open = vec4(mapDistance(LIGHT, found.x) >= distance, mapDistance(LIGHT, found.y) >= distance,
                   mapDistance(LIGHT, found.z) >= distance, mapDistance(LIGHT, found.w) >= distance);
  return mix(mix(open.w, open.z, part.x), mix(open.x, open.y, part.x), part.y);
}

// How much of the light reaches p: mean over a disc as wide as the light's blur by what stands in the way.
float shadow(vec3 p, vec3 n, float cosine) {
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec3 place = inMap(p + n * lights[LIGHT].texel * (0.6 + 1.6 * sine));
  float here = mapDistance(LIGHT, place.z), width = lights[LIGHT].texel * float(textureSize(depthMap, 0).x);
  float search = lights[LIGHT].softness * kSearch, sum = 0.0, count = 0.0;
  for (int k = 0; k < kLooks; ++k) {
    float found = mapDistance(LIGHT, textureLod(depthMap, place.xy + search * discPoint(k, kLooks, 0.0), 0.0).r);
    if (found < here) {
      sum += here - found;
      count += 1.0;
    }
  }
  float behind = count > 0.0 ? sum / count : 0.0;
  float blur = max(lights[LIGHT].softness * behind, 1.2 * lights[LIGHT].texel) / width;
  float open = 0.0;
  for (int k = 0; k < TAPS; ++k) open += passes(place.xy + blur * discPoint(k, TAPS, 1.0), here);
  return open / float(TAPS);
}

// How far the way of length d from p to where light enters is one through a plate, as T(d) has it: 0 to 1. The two sides of
// a plate face away from each other, and no part of a body is thinner than a wing of the nose: sheets closer together are
// one skin, found twice. Where the sides meet at an angle, as at a ridge or a fold, what is near passes around it already,
// with the blurs; sides that face the same way are one side.                                                        [ours]
float isPlate(float opposite, float d) {
  vec2 thinnest = mix(vec2(4.0, 8.0), vec2(0.8, 2.0), smoothstep(0.0, 0.6, opposite));  // mm: nothing, all of it
  return smoothstep(-0.6, -0.2, opposite) * smoothstep(thinnest.x, thinnest.y, d);
}

// exp(-k d) of the way through the body to where the light enters. Where the way leaves the body in between, as from a
// hand to the cheek below it, nothing comes through.                        [theory/skin.md, 7.1; the way's exits: ours]
float thickness(vec3 p, vec3 n, vec3 l) {
  float facing = -dot(n, l);
  if (facing <= 0.0) return exp(-kThickness * kNothing);
  vec3 place = inMap(p - n * lights[LIGHT].texel);
  vec2 entry = textureLod(placeMap, place.xy, 0.0).rg;
  if (!isEntry(entry)) return 0.0;
  vec3 facingIn = isInAtlas(entry) ? normalize(textureLod(normalMap, entry, 0.0).xyz) : facingOf(entry);
  float opposite = -dot(facingIn, n);
  float slant = mix(1.0, clamp(facing, 0.0, 1.0), clamp(opposite, 0.0, 1.0));
  float here = mapDistance(LIGHT, place.z), width = lights[LIGHT].texel * float(textureSize(depthMap, 0).x);
  float sum = 0.0, lift = lights[LIGHT].texel * facing;  // how far before p the look is
  for (int k = 0; k < kLooks; ++k) {
    vec2 near = place.xy + 1.0 / width * discPoint(k, kLooks, 0.0);
    float depth = textureLod(depthMap, near, 0.0).r;
    float d = max(here + lift - mapDistance(LIGHT, depth), 0.0) * slant;
    float apart = here - mapDistance(LIGHT, textureLod(exitMap, near, 0.0).r);  // mm
    sum += depth < 1.0 ? exp(-kThickness * d) * isPlate(opposite, d) * (1.0 - smoothstep(0.5, 2.0, apart)) : 0.0;
  }
  return sum / float(kLooks);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 placed = texelFetch(positionMap, texel, 0);
  if (placed.w == 0.0) {
    visibility = thin = vec4(0.0);
    return;
  }
  vec3 p = placed.xyz, n = normalize(texelFetch(normalMap, texel, 0).xyz);
  vec3 l = toLight(LIGHT, p);
  float open = texelFetch(openMap, texel, 0).w, cosine = dot(n, l), seen = mix(1.0, open, 0.7), depth = 0.0;
  if (KIND == 2 && LIGHT == 0) {
    seen = 0.0;
    depth = exp(-kThickness * density * distance(p, lights[0].position));
  } else if (lights[LIGHT].shadows > 0.0) {
    seen = cosine <= 0.0 ? 0.0 : shadow(p, n, cosine);
    if (LIGHT == 0) depth = thickness(p, n, l);
  }
  visibility = vec4(vec3(seen), open);
  thin = vec4(vec3(depth), 1.0);
}
