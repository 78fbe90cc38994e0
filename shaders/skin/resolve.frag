// From several display-linear samples per pixel to sRGB.
#include "common/colour.glsl"
#include "common/noise.glsl"

uniform sampler2D samples;
uniform int perSide;

layout(location = 0) out vec4 colour;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * perSide;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < perSide * perSide; ++i)
    sum += texelFetch(samples, first + ivec2(i % perSide, i / perSide), 0).rgb;
  colour = vec4(toSrgb(sum / float(perSide * perSide)) + (pixelNoise(gl_FragCoord.xy) - 0.5) / 255.0, 1.0);
}
