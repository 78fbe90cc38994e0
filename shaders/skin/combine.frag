// The light that has spread: the weighted sum of the blurs, and what comes through thin parts. A first Gaussian that
// is narrower than texels has weight 0: the final pass adds it at the picture's own resolution.
// Only light 0 comes through: what a scan did not see of a body is open, and the light at its back, which stands in every
// look, would shine on the insides and through them.
// Variants: KIND, see lights.glsl; SLAB or GAUSSIANS; PART: 0 all, 1 what comes through alone; SUMMED: points have summed
// the levels.
#include "skin/lights.glsl"
#include "skin/maps.glsl"

uniform sampler2D summed;          // rgb: the sum of the levels, a: smooth thinness; not premultiplied
uniform sampler2D levels[6];
uniform sampler2D thinLevels[3];   // slab: one; gaussians: before the blurs 4, 5, 6
uniform sampler2D placeMap;
uniform sampler2D transmittance;   // of a plate over 0 .. reach mm, over its reflectance
uniform vec3 weights[6];           // sum 1 per channel
uniform vec3 variances;            // of Gaussians 4, 5, 6, mm^2
uniform float reach, translucency, mixBefore;

layout(location = 0) out vec4 diffused;

const float kThickness = 0.2;  // 1/mm, as in visibility.frag

vec3 at(sampler2D map, vec2 uv) {
  vec4 value = textureLod(map, uv, 0.0);
  return value.rgb / max(value.a, 1e-4);
}

float depthOf(float thin) { return -log(max(thin, 1e-6)) / kThickness; }

// A plate of the local depth, lit from behind.                                                    [theory/skin.md, 7.3]
vec3 throughPlate(float thin, vec3 p, vec3 n) {
  float d = depthOf(thin), facing = -dot(n, toLight(0, p));
  const bool inside = KIND == 2;
  // Near the terminator depth goes to zero and the blurs carry the light already.
  float fade = inside ? 1.0 : smoothstep(0.05, 0.6, facing) * clamp(d / 3.0, 0.0, 1.0);
  float steps = float(textureSize(transmittance, 0).x);
  float place = (clamp(d / reach, 0.0, 1.0) * (steps - 1.0) + 0.5) / steps;
  vec3 share = textureLod(transmittance, vec2(place, 0.5), 0.0).rgb;
  return share * arriving(0, p) * max(facing, inside ? 0.2 : 0.0) * fade;
}

// The Gaussians themselves, at the distance of the depth.                                          [theory/skin.md, 7.2]
vec3 throughGaussians(vec2 uv, vec3 p, vec3 n) {
  vec3 l = toLight(0, p);
  if (dot(n, l) >= 0.0 || lights[0].shadows == 0.0) return vec3(0.0);
  vec4 place = lights[0].toMap * vec4(p - n * lights[0].texel, 1.0);
  vec2 entry = textureLod(placeMap, place.xy / place.w, 0.0).rg;
  if (entry.x <= 0.0) return vec3(0.0);
  vec3 entryPlace = textureLod(positionMap, entry, 0.0).xyz;
  vec3 entryNormal = normalize(textureLod(normalMap, entry, 0.0).xyz);
  // Of the light at the entry only what this light brings: the others' comes by their own way.
  vec3 all = at(levels[0], entry);
  vec3 own = arriving(0, entryPlace) * max(dot(entryNormal, l), 0.0) * pow(max(textureLod(albedoMap, entry, 0.0).rgb, vec3(0.02)), vec3(mixBefore));
  vec3 share = clamp(own / max(all, vec3(1e-5)), 0.0, 1.0), sum = vec3(0.0);
  float away = distance(p, entryPlace);
  for (int k = 0; k < 3; ++k) {
    vec3 thin = k == 0 ? at(thinLevels[0], uv) : k == 1 ? at(thinLevels[1], uv) : at(thinLevels[2], uv);
    float d = depthOf(thin.r), apart = clamp(away / (6.0 * sqrt(variances[k])), 0.0, 1.0);
    vec3 entering = k == 0 ? at(levels[3], entry) : k == 1 ? at(levels[4], entry) : at(levels[5], entry);
    sum += weights[3 + k] * exp(-d * d / (2.0 * variances[k])) * apart * entering;
  }
  return share * sum;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 placed = texelFetch(positionMap, texel, 0);
  diffused = vec4(0.0);
  if (placed.w == 0.0) return;
  vec2 uv = gl_FragCoord.xy / vec2(textureSize(positionMap, 0));
  vec3 p = placed.xyz, n = normalize(texelFetch(normalMap, texel, 0).xyz), sum = vec3(0.0), through = vec3(0.0);
#if defined(SUMMED)
  vec4 given = texelFetch(summed, texel, 0);
  if (given == vec4(0.0)) return;  // no look needs it
  float thin = given.a;
#if PART == 0
  sum = given.rgb;
#endif
#else
  float thin = at(thinLevels[0], uv).r;
#if PART == 0
  sum = weights[0] * at(levels[0], uv) + weights[1] * at(levels[1], uv) + weights[2] * at(levels[2], uv) + weights[3] * at(levels[3], uv) +
        weights[4] * at(levels[4], uv) + weights[5] * at(levels[5], uv);
#endif
#endif
#if defined(SLAB)
  through = throughPlate(thin, p, n) * pow(max(texelFetch(albedoMap, texel, 0).rgb, vec3(0.02)), vec3(mixBefore));
#else
  through = throughGaussians(uv, p, n);
#endif
  diffused = vec4(sum + translucency * through, 1.0);
}
