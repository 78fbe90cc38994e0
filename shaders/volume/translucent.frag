// Direct volume rendering: emission and absorption front to back, lit by stored gradients and by how much of the
// key light reaches each place. Premultiplied, scene-linear. Variant: SHADOWLESS: all of it does.
#include "common/lighting.glsl"
#include "common/noise.glsl"
#include "volume/ray.glsl"

in vec2 uv;

uniform sampler3D shades;      // gradient and value, see render/gpu_volume.h
#ifndef SHADOWLESS
uniform sampler3D lightMap;    // a: share of the key light that arrives, 0 to 1; rgb: in colour, as tissue leaves it
uniform vec3 lightScale;       // from places in the texture of shades to those in it
#endif
uniform sampler2D transfer;    // by value: colour, and opacity of one step
uniform float threshold;       // values up to this are transparent
uniform vec3 keyAxes, fillAxes;  // toward the lights, along the volume's axes

layout(location = 0) out vec4 colour;

void main() {
  Ray ray = makeRay(uv);
  float offset = pixelNoise(gl_FragCoord.xy);
  float t = ray.from + offset * ray.step;
  vec3 sum = vec3(0.0);
  float through = 1.0;
  vec3 ambientColour = 0.5 * (skyColour + groundColour);
  int texels = textureSize(transfer, 0).x;
  vec3 scale = 1.0 / vec3(dims);
  // Places in the texture of shades.
  vec3 start = (ray.origin + 0.5) * scale, along = ray.direction * scale;
  while (t < ray.to && through > 0.01) {
    vec3 index = ray.origin + t * ray.direction;
    // A loop of its own: a software rasteriser runs the whole body of a loop for every turn of it.
    while (t < ray.to && brickMaximum(index) <= threshold) {
      t = leap(ray, t, index, offset);
      index = ray.origin + t * ray.direction;
    }
    // Some samples before the next look at the bricks, which costs half of one.
    for (int n = 0; n < 4; ++n) {
      vec3 place = start + t * along;
      vec4 shade = texture(shades, place);
#ifdef ERASED
      if (isErased(ray.origin + t * ray.direction)) shade.w = 0.0;
#endif
      shade.w = t < ray.to ? shade.w : 0.0;
      vec4 look = texelFetch(transfer, ivec2(shade.w * float(texels - 1) + 0.5, 0), 0);
      vec3 gradient = 2.0 * shade.xyz - 256.0 / 255.0;
      float squared = dot(gradient, gradient), inverse = inversesqrt(max(squared, 1e-8));
      float surfaceness = clamp(6.0 * squared * inverse, 0.0, 1.0);
      float key = mix(0.55, max(0.25 - 0.85 * inverse * dot(gradient, keyAxes), 0.0), surfaceness);
      float fill = mix(0.5, max(0.3 - 0.7 * inverse * dot(gradient, fillAxes), 0.0), surfaceness);
#ifdef SHADOWLESS
      vec3 light = keyColour * key + fillColour * fill + ambientColour;
#else
      vec4 arriving = texture(lightMap, place * lightScale);
      vec3 light = keyColour * key * arriving.rgb + fillColour * fill + ambientColour * (0.35 + 0.65 * arriving.a);
#endif
      sum += through * look.a * look.rgb * light;
      through *= 1.0 - look.a;
      t += ray.step;
    }
  }
  colour = vec4(sum, 1.0 - through);
}
