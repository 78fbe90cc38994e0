// Ambient occlusion from the depth of a picture, one value per screen pixel. [after McGuire et al. 2011, Alchemy]
#include "common/noise.glsl"

in vec2 uv;

uniform sampler2D depthMap;
uniform int step;                 // depth texels per screen pixel
uniform vec2 tangents;            // of half the field of view, horizontal and vertical
uniform vec2 depthTerms;          // distance = depthTerms.x / (depthTerms.y - depth)
uniform float radius;             // mm
uniform float pixelsPerTangent;   // screen pixels per unit of x / distance

layout(location = 0) out vec2 result;  // light that arrives, 0 to 1, and the distance in mm

float distanceAt(ivec2 pixel) {
  ivec2 last = textureSize(depthMap, 0) - 1;
  float depth = texelFetch(depthMap, clamp(pixel * step, ivec2(0), last), 0).r;
  return depthTerms.x / (depthTerms.y - depth);
}

vec3 positionAt(ivec2 pixel, float distance) {
  vec2 size = vec2(textureSize(depthMap, 0)) / float(step);
  return vec3((2.0 * (vec2(pixel) + 0.5) / size - 1.0) * tangents, 1.0) * distance;
}

// The shorter of two differences: the one that does not jump over an edge.
vec3 shorter(vec3 a, vec3 b) { return abs(a.z) < abs(b.z) ? a : b; }

vec3 normalAt(ivec2 p, vec3 centre) {
  vec3 left = positionAt(p - ivec2(2, 0), distanceAt(p - ivec2(2, 0)));
  vec3 right = positionAt(p + ivec2(2, 0), distanceAt(p + ivec2(2, 0)));
  vec3 below = positionAt(p - ivec2(0, 2), distanceAt(p - ivec2(0, 2)));
  vec3 above = positionAt(p + ivec2(0, 2), distanceAt(p + ivec2(0, 2)));
  vec3 across = shorter(right - centre, centre - left), up = shorter(above - centre, centre - below);
  return normalize(cross(up, across));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depthMap, pixel * step, 0).r;
  if (depth >= 1.0) {
    result = vec2(1.0, 1e4);
    return;
  }
  float distance = depthTerms.x / (depthTerms.y - depth);
  vec3 centre = positionAt(pixel, distance);
  vec3 normal = normalAt(pixel, centre);
  const int taps = 14;
  float spread = radius * pixelsPerTangent / distance;
  float angle = 6.2831853 * pixelNoise(gl_FragCoord.xy);
  float hidden = 0.0;
  for (int i = 0; i < taps; ++i) {
    ivec2 p = pixel + ivec2(round(spread * discPoint(i, taps, angle)));
    vec3 v = positionAt(p, distanceAt(p)) - centre;
    float squared = dot(v, v);
    float near = max(1.0 - squared / (radius * radius), 0.0);
    hidden += near * max(dot(v, normal) - 0.012 * radius, 0.0) * inversesqrt(squared + 1e-4 * radius * radius);
  }
  result = vec2(clamp(1.0 - 2.2 * hidden / float(taps), 0.0, 1.0), distance);
}
