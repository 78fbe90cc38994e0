// How much of a pixel the surface covers. Few samples per pixel are shaded; where a surface ends, more are counted.
uniform sampler2D outlineMap;  // share of each of a pixel's perSide x perSide texels

float coverage(ivec2 pixel, int perSide) {
  float sum = 0.0;
  for (int i = 0; i < perSide * perSide; ++i)
    sum += texelFetch(outlineMap, pixel * perSide + ivec2(i % perSide, i / perSide), 0).r;
  return sum / float(perSide * perSide);
}
