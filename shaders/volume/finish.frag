// From premultiplied scene-linear samples, one per pixel, to an sRGB picture.
#include "common/colour.glsl"
#include "common/noise.glsl"

in vec2 uv;

uniform sampler2D samples;
uniform vec3 backgroundTop, backgroundBottom;
uniform float exposure;

layout(location = 0) out vec4 colour;

void main() {
  vec4 s = texture(samples, uv);
  float height = uv.y + 0.25 * (uv.x - 0.5) * (uv.x - 0.5);
  vec3 background = mix(backgroundBottom, backgroundTop, smoothstep(0.0, 1.0, height));
  float dither = (pixelNoise(gl_FragCoord.xy) - 0.5) / 255.0;
  colour = vec4(toSrgb(toneMap(exposure * s.rgb) + (1.0 - s.a) * background) + dither, 1.0);
}
