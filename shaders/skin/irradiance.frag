// What light enters the skin at every texel of the atlas, and how deep the skin is there as each light sees it.
// Variants: KIND, see lights.glsl; TAPS: looks into a depth map.                      [skin specification, section 7]
#include "common/noise.glsl"
#include "skin/lights.glsl"
#include "skin/maps.glsl"
#include "skin/reflection.glsl"

uniform sampler2D depthMaps[3];
uniform sampler2D placeMaps[3];
uniform sampler2D exitMaps[3];  // depths where light first leaves the body
uniform float mixBefore;  // share of the colour that light takes up before it spreads
uniform float density;    // of tissue before a light inside

layout(location = 0) out vec4 entering;    // rgb, a: coverage; premultiplied
layout(location = 1) out vec4 visibility;  // of the three lights; open sky
layout(location = 2) out vec4 thin;        // exp(-k depth) as each light sees it; a: coverage; premultiplied

const float kThickness = 0.2;  // 1/mm
const float kNothing = 50.0;   // mm: as good as opaque
const int kLooks = TAPS < 16 ? 4 : 8;  // for what stands in the way, and for depth

vec3 inMap(int i, vec3 p) {
  vec4 place = lights[i].toMap * vec4(p, 1.0);
  return place.xyz / place.w;
}

// Share of the four texels around a place that are not nearer than `distance`, weighted by their overlap.
float passes(int i, sampler2D depths, vec2 place, float distance) {
  vec2 size = vec2(textureSize(depths, 0)), texel = place * size - 0.5, part = fract(texel);
  vec4 found = textureGather(depths, (floor(texel) + 1.0) / size);
  vec4 open = vec4(mapDistance(i, found.x) >= distance, mapDistance(i, found.y) >= distance,
                   mapDistance(i, found.z) >= distance, mapDistance(i, found.w) >= distance);
  return mix(mix(open.w, open.z, part.x), mix(open.x, open.y, part.x), part.y);
}

// How much of the light reaches p: mean over a disc as wide as the light's blur by what stands in the way.
float shadow(int i, sampler2D depths, vec3 p, vec3 n, float cosine) {
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  vec3 place = inMap(i, p + n * lights[i].texel * (0.6 + 1.6 * sine));
  float here = mapDistance(i, place.z), width = lights[i].texel * float(textureSize(depths, 0).x);
  float search = lights[i].softness * 12.0 / width, sum = 0.0, count = 0.0;
  for (int k = 0; k < kLooks; ++k) {
    float found = mapDistance(i, textureLod(depths, place.xy + search * discPoint(k, kLooks, 0.0), 0.0).r);
    if (found < here) {
      sum += here - found;
      count += 1.0;
    }
  }
  float behind = count > 0.0 ? sum / count : 0.0;
  float blur = max(lights[i].softness * behind, 1.2 * lights[i].texel) / width;
  float open = 0.0;
  for (int k = 0; k < TAPS; ++k) open += passes(i, depths, place.xy + blur * discPoint(k, TAPS, 1.0), here);
  return open / float(TAPS);
}

// exp(-k d) of the way through the body to where the light enters. Where the way leaves the body in between, as from a
// hand to the cheek below it, nothing comes through.            [skin specification, section 9.1; the way's exits: ours]
float thickness(int i, sampler2D depths, sampler2D places, sampler2D exits, vec3 p, vec3 n, vec3 l) {
  float facing = -dot(n, l);
  if (facing <= 0.0) return exp(-kThickness * kNothing);
  vec3 place = inMap(i, p - n * lights[i].texel);
  vec2 entry = textureLod(places, place.xy, 0.0).rg;
  if (entry.x <= 0.0) return 0.0;
  vec3 entryNormal = normalize(textureLod(normalMap, entry, 0.0).xyz);
  float slant = mix(1.0, clamp(facing, 0.0, 1.0), clamp(-dot(entryNormal, n), 0.0, 1.0));
  float here = mapDistance(i, place.z), width = lights[i].texel * float(textureSize(depths, 0).x), sum = 0.0;
  for (int k = 0; k < kLooks; ++k) {
    vec2 near = place.xy + 1.0 / width * discPoint(k, kLooks, 0.0);
    float depth = textureLod(depths, near, 0.0).r;
    float d = max(here - mapDistance(i, depth), 0.0) * slant;
    float apart = here - mapDistance(i, textureLod(exits, near, 0.0).r);  // mm
    sum += depth < 1.0 ? exp(-kThickness * d) * (1.0 - smoothstep(0.5, 2.0, apart)) : 0.0;
  }
  return sum / float(kLooks);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 placed = texelFetch(positionMap, texel, 0);
  if (placed.w == 0.0) {
    entering = visibility = thin = vec4(0.0);
    return;
  }
  vec3 p = placed.xyz, n = normalize(texelFetch(normalMap, texel, 0).xyz);
  vec4 open = texelFetch(openMap, texel, 0);
  vec4 finish = texelFetch(finishMap, texel, 0);
  vec3 sum = open.w * irradianceAround(normalize(open.xyz + n * 1e-3)) * (1.0 - finish.g * reflected(0.0, finish.r).y);
  float seen[3], depth[3];
  for (int i = 0; i < 3; ++i) {
    vec3 l = toLight(i, p);
    float cosine = dot(n, l);
    seen[i] = mix(1.0, open.w, 0.7);
    depth[i] = 0.0;
    if (KIND == 2 && i == 0) {
      seen[i] = 0.0;
      depth[i] = exp(-kThickness * density * distance(p, lights[0].position));
    } else if (lights[i].shadows > 0.0) {
      // Samplers must be named by constants.
      seen[i] = cosine <= 0.0 ? 0.0 : i == 0 ? shadow(0, depthMaps[0], p, n, cosine)
                                  : i == 1  ? shadow(1, depthMaps[1], p, n, cosine)
                                            : shadow(2, depthMaps[2], p, n, cosine);
      depth[i] = i == 0   ? thickness(0, depthMaps[0], placeMaps[0], exitMaps[0], p, n, l)
                 : i == 1 ? thickness(1, depthMaps[1], placeMaps[1], exitMaps[1], p, n, l)
                          : thickness(2, depthMaps[2], placeMaps[2], exitMaps[2], p, n, l);
    }
    float entry = 1.0 - finish.g * reflected(cosine, finish.r).x;
    sum += arriving(i, p) * seen[i] * max(cosine, 0.0) * entry;
  }
  vec3 albedo = max(texelFetch(albedoMap, texel, 0).rgb, vec3(0.02));
  entering = vec4(pow(albedo, vec3(mixBefore)) * sum, 1.0);
  visibility = vec4(seen[0], seen[1], seen[2], open.w);
  thin = vec4(depth[0], depth[1], depth[2], 1.0);
}
