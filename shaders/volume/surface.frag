// First hit of an iso-surface: bright is inside. Lit, scene-linear, with depth. Variant: SHADOW.
#include "common/lighting.glsl"
#include "common/noise.glsl"
#include "volume/ray.glsl"

in vec2 uv;

uniform sampler3D values;
uniform float iso;
uniform float smoothing;        // voxels between the two samples of a gradient, halved
uniform mat3 gradientToWorld;   // from differences per voxel
uniform vec3 keyIndex;          // voxel indices per mm toward the key light
uniform float diagonal;         // of the volume, mm
uniform vec2 depthTerms;        // distance = depthTerms.x / (depthTerms.y - depth)

layout(location = 0) out vec4 colour;  // rgb, and the share of it that ambient occlusion may take away

float valueAt(vec3 index) { return texture(values, (index + 0.5) / vec3(dims)).r; }

// The first t at which the value reaches iso, or a negative number.
float firstHit(Ray ray) {
  float offset = pixelNoise(gl_FragCoord.xy);
  float t = ray.from + offset * ray.step;
  while (t < ray.to) {
    vec3 index = eyeIndex + t * ray.direction;
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
  for (int i = 0; i < 6; ++i) {
    float middle = 0.5 * (outside + inside);
    bool hit = valueAt(eyeIndex + middle * ray.direction) >= iso;
    inside = hit ? middle : inside;
    outside = hit ? outside : middle;
  }
  return 0.5 * (outside + inside);
}

vec3 outwardNormal(vec3 index) {
  vec2 h = vec2(smoothing, 0.0);
  vec3 gradient = vec3(valueAt(index + h.xyy) - valueAt(index - h.xyy),
                       valueAt(index + h.yxy) - valueAt(index - h.yxy),
                       valueAt(index + h.yyx) - valueAt(index - h.yyx));
  vec3 normal = -gradientToWorld * gradient;
  return dot(normal, normal) > 1e-12 ? normalize(normal) : -keyDirection;
}

// The outward normal of the side of the box at which a ray enters.
vec3 sideNormal(vec3 index) {
  vec3 low = abs(index - boxMin), high = abs(index - boxMax);
  vec3 nearer = min(low, high);
  vec3 axis = vec3(lessThanEqual(nearer, vec3(min(nearer.x, min(nearer.y, nearer.z)))));
  vec3 sign = mix(vec3(1.0), vec3(-1.0), lessThan(low, high));
  return normalize(transpose(inverse(gradientToWorld)) * (axis * sign));
}

#ifdef SHADOW
// Light of the key that arrives: 1 in the open, falling to 0 where something stands between.
float keyShadow(vec3 index) {
  float reach = 0.35 * diagonal, t = (0.6 + 0.8 * pixelNoise(gl_FragCoord.yx + 17.0)) * 2.5 * stepLength;
  float light = 1.0;
  while (t < reach && light > 0.02) {
    vec3 p = index + t * keyIndex;
    if (any(lessThan(p, boxMin)) || any(greaterThan(p, boxMax))) break;
    if (brickMaximum(p) < 0.8 * iso) {
      t += brickExit(p, keyIndex) + 0.1 * stepLength;
    } else {
      float covered = smoothstep(0.85 * iso, 1.25 * iso, valueAt(p));
      light = min(light, 1.0 - covered);
      t += 1.5 * stepLength;
    }
  }
  return light;
}
#endif

void main() {
  Ray ray = makeRay(uv);
  bool atSide = ray.from < ray.to && ray.from > 0.0 && valueAt(eyeIndex + ray.from * ray.direction) >= iso;
  float t = atSide ? ray.from : firstHit(ray);
  if (t < 0.0) discard;
  if (!atSide) t = refined(ray, t);
  vec3 index = eyeIndex + t * ray.direction;
  vec3 normal = atSide ? sideNormal(index) : outwardNormal(index);
  vec3 toEye = -ray.world;
  const vec3 albedo = vec3(0.80, 0.47, 0.26), wrap = vec3(0.40, 0.20, 0.12);
  float light = 1.0;
#ifdef SHADOW
  light = keyShadow(index);
#endif
  vec3 key = keyColour * pow(vec3(light), vec3(0.6, 0.95, 1.05));
  vec3 direct = albedo * (key * wrapped(dot(normal, keyDirection), wrap) +
                          fillColour * wrapped(dot(normal, fillDirection), wrap));
  direct += 0.7 * key * specular(normal, toEye, keyDirection, 0.5, 0.03);
  float edge = pow(1.0 - max(dot(normal, toEye), 0.0), 3.0);
  vec3 ambient = albedo * (hemisphere(normal) + rimColour * edge * (0.4 + 0.6 * max(dot(normal, rimDirection), 0.0)));
  vec3 sum = direct + ambient;
  if (atSide) sum *= 0.45;
  colour = vec4(sum, mix(0.45, 1.0, luminance(ambient) / max(luminance(sum), 1e-6)));
  gl_FragDepth = clamp(depthTerms.y - depthTerms.x / t, 0.0, 1.0);
}
