// Ambient occlusion of a surface buffer, one value per screen pixel. [after McGuire et al. 2011, Alchemy]
#include "common/noise.glsl"
#include "common/screen.glsl"

in vec2 uv;

uniform sampler2D normalMap, depthMap;
uniform int step;                 // samples per pixel along one side
uniform float radius;             // mm
uniform float pixelsPerTangent;   // screen pixels per unit of x / distance

layout(location = 0) out vec2 result;  // light that arrives, 0 to 1, and the distance in mm

vec3 offsetTo(ivec2 pixel, vec3 centre, vec2 uvPerPixel) {
  ivec2 texel = clamp(pixel * step, ivec2(0), textureSize(depthMap, 0) - 1);
  float distance = distanceOf(texelFetch(depthMap, texel, 0).r);
  return distance * rayAt((vec2(pixel) + 0.5) * uvPerPixel) - centre;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depthMap, pixel * step, 0).r;
  float distance = distanceOf(depth);
  vec3 centre = distance * rayAt(uv);
  vec3 normal = normalize(texelFetch(normalMap, pixel * step, 0).xyz);
  vec2 uvPerPixel = float(step) / vec2(textureSize(depthMap, 0));
  float spread = radius * pixelsPerTangent / distance;
  float angle = 6.2831853 * pixelNoise(gl_FragCoord.xy);
  // A loop without turns is how a software rasteriser skips the background.
  int taps = depth < 1.0 ? 14 : 0;
  float hidden = 0.0;
  for (int i = 0; i < taps; ++i) {
    vec3 v = offsetTo(pixel + ivec2(round(spread * discPoint(i, 14, angle))), centre, uvPerPixel);
    float squared = dot(v, v);
    float near = max(1.0 - squared / (radius * radius), 0.0);
    hidden += near * max(dot(v, normal) - 0.012 * radius, 0.0) * inversesqrt(squared + 1e-4 * radius * radius);
  }
  result = vec2(clamp(1.0 - 2.4 * hidden / 14.0, 0.0, 1.0), distance);
}
