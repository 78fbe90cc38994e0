// Maximum intensity: the largest value along a ray, as a grey. Premultiplied, display-linear.
#include "common/colour.glsl"
#include "common/noise.glsl"
#include "volume/ray.glsl"

in vec2 uv;

uniform sampler3D values;
uniform vec2 window;    // shown = value * x + y
uniform float brightest;  // a value from which on everything is white: no ray looks farther

layout(location = 0) out vec4 colour;

void main() {
  Ray ray = makeRay(uv);
  float offset = pixelNoise(gl_FragCoord.xy);
  float t = ray.from + offset * ray.step;
  float most = 0.0;
  vec3 scale = 1.0 / vec3(dims);
  while (t < ray.to && most < brightest) {
    vec3 index = ray.origin + t * ray.direction;
    // Bricks that hold nothing brighter than what was seen change nothing.
    while (t < ray.to && brickMaximum(index) <= most) {
      t = leap(ray, t, index, offset);
      index = ray.origin + t * ray.direction;
    }
    float value = texture(values, (index + 0.5) * scale).r;
    most = isErased(index) || t >= ray.to ? most : max(most, value);
    t += ray.step;
  }
  float shown = most > 0.0 ? clamp(most * window.x + window.y, 0.0, 1.0) : 0.0;
  colour = vec4(fromSrgb(vec3(shown)) * shown, shown);
}
