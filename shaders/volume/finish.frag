// From premultiplied linear samples to an sRGB picture over what is behind. Variants: DISPLAY: they are display-linear, else
// scene-linear; BEHIND: a picture is behind them, else a soft gradient.
#include "common/colour.glsl"
#include "common/noise.glsl"

in vec2 uv;

uniform sampler2D samples;
uniform vec3 backgroundTop, backgroundBottom;
uniform float backdrop;  // 1 or 0: whether there is a background
uniform float exposure;
#ifdef BEHIND
uniform sampler2D behind;  // sRGB, straight alpha
#endif

layout(location = 0) out vec4 colour;

vec4 whatIsBehind() {
#ifdef BEHIND
  vec4 picture = texture(behind, uv);
  return vec4(fromSrgb(picture.rgb), picture.a);
#else
  float height = uv.y + 0.25 * (uv.x - 0.5) * (uv.x - 0.5);
  return vec4(mix(backgroundBottom, backgroundTop, smoothstep(0.0, 1.0, height)), backdrop);
#endif
}

void main() {
  vec4 s = texture(samples, uv), far = whatIsBehind();
#ifdef DISPLAY
  vec3 near = s.rgb;
#else
  vec3 near = toneMap(exposure * s.rgb);
#endif
  float covered = s.a + (1.0 - s.a) * far.a;
  vec3 linear = (near + (1.0 - s.a) * far.a * far.rgb) / max(covered, 1e-4);
  float dither = (pixelNoise(gl_FragCoord.xy) - 0.5) / 255.0;
  colour = vec4(toSrgb(linear) + dither, covered);
}
