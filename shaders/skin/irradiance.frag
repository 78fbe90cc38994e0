// What light enters the skin at every texel of the atlas. Variants: KIND, see lights.glsl.              [theory/skin.md, 4.3]
#include "common/occlusion.glsl"
#include "skin/lights.glsl"
#include "skin/maps.glsl"
#include "skin/reflection.glsl"

uniform sampler2D visibilityMap;
uniform float mixBefore;  // share of the colour that light takes up before it spreads

layout(location = 0) out vec4 entering;  // rgb, a: coverage; premultiplied

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 placed = texelFetch(positionMap, texel, 0);
  if (placed.w == 0.0) {
    entering = vec4(0.0);
    return;
  }
  vec3 p = placed.xyz, n = normalize(texelFetch(normalMap, texel, 0).xyz);
  vec4 open = texelFetch(openMap, texel, 0), seen = texelFetch(visibilityMap, texel, 0);
  vec4 finish = texelFetch(finishMap, texel, 0);
  vec3 albedo = max(texelFetch(albedoMap, texel, 0).rgb, vec3(0.02));
  vec3 sum = reflectedOcclusion(open.w, albedo) * irradianceAround(normalize(open.xyz + n * 1e-3)) * (1.0 - finish.g * reflected(0.0, finish.r).y);
  for (int i = 0; i < 3; ++i) {
    float cosine = dot(n, toLight(i, p));
    float entry = 1.0 - finish.g * reflected(cosine, finish.r).x;
    sum += arriving(i, p) * seen[i] * max(cosine, 0.0) * entry;
  }
  entering = vec4(pow(albedo, vec3(mixBefore)) * sum, 1.0);
}
