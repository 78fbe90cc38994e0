// How much light arrives at a surface buffer, one value per screen pixel: from all around [after McGuire et al. 2011,
// Alchemy] and from the key light (percentage-closer filtering of a shadow map). Both are noisy with a period of 4x4
// pixels; surface/shade.frag takes the mean over it.
#include "common/noise.glsl"
#include "common/screen.glsl"

in vec2 uv;

uniform sampler2D normalMap, depthMap;
uniform int step;                 // samples per pixel along one side
uniform float radius;             // mm
uniform float pixelsPerTangent;   // screen pixels per unit of x / distance

uniform sampler2DShadow shadowMap;
uniform mat4 shadowMatrix;        // world -> shadow map, each axis 0 to 1
uniform float shadowOffset;       // mm along the normal, against a surface shadowing itself
uniform float shadowRadius;       // of the penumbra, in shadow-map units
uniform vec3 keyDirection;        // unit, toward the light

layout(location = 0) out vec4 result;  // light from all around, distance in mm, light of the key; 0 to 1

const int occlusionTaps = 14, shadowTaps = 8;

vec3 offsetTo(ivec2 pixel, vec3 centre, vec2 uvPerPixel) {
  ivec2 texel = clamp(pixel * step, ivec2(0), textureSize(depthMap, 0) - 1);
  float distance = distanceOf(texelFetch(depthMap, texel, 0).r);
  return distance * rayAt((vec2(pixel) + 0.5) * uvPerPixel) - centre;
}

// The nearest of the pixel's samples.
ivec2 nearestSample(ivec2 pixel) {
  ivec2 best = pixel * step;
  float least = 1.0;
  for (int i = 0; i < step * step; ++i) {
    ivec2 texel = pixel * step + ivec2(i % step, i / step);
    float depth = texelFetch(depthMap, texel, 0).r;
    best = depth < least ? texel : best;
    least = min(least, depth);
  }
  return best;
}

float keyShadow(vec3 position, vec3 normal, float angle, int taps) {
  float slope = 1.0 - abs(dot(normal, keyDirection));
  vec3 place = (shadowMatrix * vec4(position + normal * shadowOffset * (0.3 + slope), 1.0)).xyz;
  float light = 0.0;
  for (int i = 0; i < taps; ++i)
    light += texture(shadowMap, place + vec3(shadowRadius * discPoint(i, shadowTaps, angle), 0.0));
  return light / float(shadowTaps);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), texel = nearestSample(pixel);
  float depth = texelFetch(depthMap, texel, 0).r;
  float distance = distanceOf(depth);
  vec3 centre = distance * rayAt(uv);
  vec3 normal = normalize(texelFetch(normalMap, texel, 0).xyz);
  vec2 uvPerPixel = float(step) / vec2(textureSize(depthMap, 0));
  float spread = radius * pixelsPerTangent / distance;
  float angle = 6.2831853 * pixelNoise(gl_FragCoord.xy);
  // A loop without turns is how a software rasteriser skips the background.
  int taps = depth < 1.0 ? occlusionTaps : 0;
  float hidden = 0.0;
  for (int i = 0; i < taps; ++i) {
    vec3 v = offsetTo(pixel + ivec2(round(spread * discPoint(i, occlusionTaps, angle))), centre, uvPerPixel);
    float squared = dot(v, v);
    float near = max(1.0 - squared / (radius * radius), 0.0);
    hidden += near * max(dot(v, normal) - 0.012 * radius, 0.0) * inversesqrt(squared + 1e-4 * radius * radius);
  }
  float key = keyShadow(eye + centre, normal, angle, depth < 1.0 ? shadowTaps : 0);
  result = vec4(clamp(1.0 - 2.4 * hidden / float(occlusionTaps), 0.0, 1.0), distance, key, 0.0);
}
