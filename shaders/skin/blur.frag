// One direction of a Gaussian blur on the surface. Texels that show nothing do not count, so that light ends at the
// surface's borders instead of leaking out. TAPS: on either side.                                 [theory/skin.md, 5.1]
uniform sampler2D light;       // premultiplied by coverage
uniform sampler2D stretchMap;  // mm per texel
uniform vec2 size;             // texels of what is drawn into; wide blurs have coarser maps
uniform vec2 axis;             // (1,0) or (0,1)
uniform float sigma;           // mm
uniform float places[TAPS + 1], weights[TAPS + 1];

layout(location = 0) out vec4 blurred;

void main() {
  vec2 middle = gl_FragCoord.xy / size;
  vec4 sum = weights[0] * textureLod(light, middle, 0.0);
  if (sum.a == 0.0) {
    blurred = vec4(0.0);
    return;
  }
  vec2 fine = vec2(textureSize(stretchMap, 0));
  vec2 step = sigma * axis / (texelFetch(stretchMap, ivec2(middle * fine), 0).rg * fine);
  for (int i = 1; i <= TAPS; ++i) {
    vec2 away = places[i] * step;
    sum += weights[i] * (textureLod(light, middle + away, 0.0) + textureLod(light, middle - away, 0.0));
  }
  // Where half floats are cut off instead of rounded, a hair more keeps even light even.
  blurred = sum / sum.a * (1.0 + 2e-6);
}
