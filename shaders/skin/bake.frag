// The skin's maps as files have them, over the atlas.
// MAP: 0 colour; 1 finish as glTF has it (green roughness, blue metalness); 2 normals in tangent space; 3 colour of the
// light that the surface sends out, without reflections.
#include "common/colour.glsl"
#include "skin/detail.glsl"
#include "skin/maps.glsl"

uniform sampler2D irradianceMap, diffusedMap;
uniform vec3 firstWeight;      // of the narrowest Gaussian
uniform float detail, mixBefore, exposure;

layout(location = 0) out vec4 colour;

// Where light has not been spread, beyond the charts, what arrives is as good a filling.
vec3 sentOut(ivec2 texel, vec3 albedo) {
  vec4 arriving = texelFetch(irradianceMap, texel, 0), spread = texelFetch(diffusedMap, texel, 0);
  arriving.rgb /= max(arriving.a, 1e-4);
  vec3 entered = spread.a > 0.0 ? firstWeight * arriving.rgb + spread.rgb / spread.a : arriving.rgb;
  return toneMap(exposure * pow(max(albedo, vec3(0.02)), vec3(1.0 - mixBefore)) * entered);
}

// How the place in mm changes from one texel to the next along u; only where both are on the surface.
vec3 alongU(ivec2 texel) {
  vec4 left = texelFetch(positionMap, texel - ivec2(1, 0), 0), right = texelFetch(positionMap, texel + ivec2(1, 0), 0);
  vec4 here = texelFetch(positionMap, texel, 0);
  if (left.w == 0.0) left = here;
  if (right.w == 0.0) right = here;
  return right.xyz - left.xyz;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 placed = texelFetch(positionMap, texel, 0);
  bool there = placed.w > 0.0;
  vec3 albedo = there ? texelFetch(albedoMap, texel, 0).rgb : vec3(0.45, 0.3, 0.23);
  vec4 finish = there ? texelFetch(finishMap, texel, 0) : vec4(0.3, 0.0, 0.0, 0.0);
  float m = finish.r;
  vec3 along = alongU(texel), n = texelFetch(normalMap, texel, 0).xyz;
  bool level = !there || dot(along, along) == 0.0 || dot(n, n) == 0.0;
  vec3 turned = vec3(0.0, 0.0, 1.0);
  if (!level) {
    n = normalize(n);
    vec3 tangent = normalize(along - dot(along, n) * n);
    vec3 bumpy = bumped(n, placed.xyz, length(along) * 0.5, detail * (1.0 - 0.7 * finish.a) * (1.0 - 0.5 * finish.b), m);
    turned = vec3(dot(bumpy, tangent), dot(bumpy, cross(n, tangent)), dot(bumpy, n));
  }
#if MAP == 0
  vec3 shown = toSrgb(albedo);
#elif MAP == 1
  vec3 shown = vec3(0.0, sqrt(clamp(m, 0.0, 1.0)), 0.0);  // Beckmann's slope is about the square of glTF's roughness
#elif MAP == 2
  vec3 shown = 0.5 + 0.5 * turned;
#else
  vec3 shown = toSrgb(there ? sentOut(texel, albedo) : albedo);
#endif
  colour = vec4(shown, 1.0);
}
