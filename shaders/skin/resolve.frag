// From several display-linear samples per pixel to sRGB, over what is behind the skin.
#include "common/colour.glsl"
#include "common/noise.glsl"
#include "common/outline.glsl"
#include "skin/background.glsl"

in vec2 uv;

uniform sampler2D samples;  // a: 1 where the surface is, else 0
uniform int perSide;
uniform float backdrop;     // 1 or 0: whether there is a background
uniform int firstRow;       // of the pixels whose samples these are

layout(location = 0) out vec4 colour;

void main() {
  ivec2 first = (ivec2(gl_FragCoord.xy) - ivec2(0, firstRow)) * perSide;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < perSide * perSide; ++i)
    sum += texelFetch(samples, first + ivec2(i % perSide, i / perSide), 0);
  float covered = sum.a > 0.0 ? coverage(ivec2(gl_FragCoord.xy), perSide) : 0.0;
  vec3 linear = mix(background(uv), sum.rgb / max(sum.a, 1.0), backdrop > 0.0 ? covered : 1.0);
  colour = vec4(toSrgb(linear) + (pixelNoise(gl_FragCoord.xy) - 0.5) / 255.0, max(covered, backdrop));
}
