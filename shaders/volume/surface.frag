// First hit of an iso-surface: bright is inside. Fills a surface buffer.
// Variant: DEPTH_ONLY (a shadow map).
#include "common/noise.glsl"
#include "surface/buffer.glsl"
#include "volume/ray.glsl"

in vec2 uv;

uniform sampler3D values;
uniform float iso;
uniform float gradientReach;    // voxels to each side
uniform mat3 gradientToWorld;   // from differences per voxel
uniform vec2 depthTerms;        // perspective: depth = depthTerms.y - depthTerms.x / t; else depthTerms.x * t

#ifndef DEPTH_ONLY
layout(location = 0) out vec4 surface;
#endif

float valueAt(vec3 index) { return isErased(index) ? 0.0 : texture(values, (index + 0.5) / vec3(dims)).r; }

// The first t at which the value reaches iso, or a negative number.
float firstHit(Ray ray) {
  float offset = pixelNoise(gl_FragCoord.xy);
  float t = ray.from + offset * ray.step;
  while (t < ray.to) {
    vec3 index = ray.origin + t * ray.direction;
    if (brickMaximum(index) < iso) {
      t = leap(ray, t, index, offset);
    } else {
      if (valueAt(index) >= iso) return t;
      t += ray.step;
    }
  }
  return -1.0;
}

// Between the last sample outside and the first inside: bisection.
float refined(Ray ray, float inside) {
  float outside = max(inside - ray.step, ray.from);
  for (int i = 0; i < 7; ++i) {
    float middle = 0.5 * (outside + inside);
    bool hit = valueAt(ray.origin + middle * ray.direction) >= iso;
    inside = hit ? middle : inside;
    outside = hit ? outside : middle;
  }
  return 0.5 * (outside + inside);
}

vec3 outwardNormal(vec3 index) {
  vec2 h = vec2(gradientReach, 0.0);
  vec3 gradient = vec3(valueAt(index + h.xyy) - valueAt(index - h.xyy),
                       valueAt(index + h.yxy) - valueAt(index - h.yxy),
                       valueAt(index + h.yyx) - valueAt(index - h.yyx));
  vec3 normal = -gradientToWorld * gradient;
  return dot(normal, normal) > 1e-12 ? normalize(normal) : -viewCentre;
}

// The outward normal of the side of the box, or of the plane, at which a ray enters.
vec3 sideNormal(vec3 index, bool cut) {
  if (cut) return normalize(gradientToWorld * -clip.xyz);
  vec3 low = abs(index - boxMin), high = abs(index - boxMax);
  vec3 nearer = min(low, high);
  vec3 axis = vec3(lessThanEqual(nearer, vec3(min(nearer.x, min(nearer.y, nearer.z)))));
  return normalize(gradientToWorld * (axis * mix(vec3(1.0), vec3(-1.0), lessThan(low, high))));
}

void main() {
  Ray ray = makeRay(uv);
  bool atSide = ray.from < ray.to && ray.from > 0.0 && valueAt(ray.origin + ray.from * ray.direction) >= iso;
  float t = atSide ? ray.from : firstHit(ray);
  if (t < 0.0) discard;
#ifdef DEPTH_ONLY
  gl_FragDepth = clamp(depthTerms.x * t, 0.0, 1.0);
#else
  if (!atSide) t = refined(ray, t);
  vec3 index = ray.origin + t * ray.direction;
  // Where the box cuts through tissue, one looks at its inside.
  surface = atSide ? innerSurface(sideNormal(index, ray.cut), 1.0) : outerSurface(outwardNormal(index), 1.0);
  gl_FragDepth = clamp(depthTerms.y - depthTerms.x / t, 0.0, 1.0);
#endif
}
