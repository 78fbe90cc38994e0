// Only what is behind the skin.
#include "common/colour.glsl"
#include "common/noise.glsl"
#include "skin/background.glsl"

in vec2 uv;

layout(location = 0) out vec4 colour;

uniform float backdrop;  // 1 or 0: whether there is a background

void main() {
  colour = vec4(toSrgb(background(uv)) + (pixelNoise(gl_FragCoord.xy) - 0.5) / 255.0, backdrop);
}
