// Pores and fine lines. DETAIL: their layers, 0 to 2.
uniform sampler3D detailTile;  // gradient of the height, per mm of its own frame; w: height
uniform float tileLength;      // mm
uniform vec2 lostSlope;        // mean squared slope of each layer

// Slopes that are too fine for the picture make it rougher instead of sparkling.                  [theory/skin.md, 10.3]
vec3 bumped(vec3 n, vec3 p, float pixel, float strength, inout float m) {
#if DETAIL > 0
  const float frequency[2] = float[](2.5, 0.45);  // per mm
  const float stretch[2] = float[](1.0, 5.3);
  vec3 slope = vec3(0.0);
  for (int k = 0; k < DETAIL; ++k) {
    float weight = clamp(2.0 - 2.0 * frequency[k] * pixel, 0.0, 1.0);
    slope += weight * textureLod(detailTile, p / (tileLength * stretch[k]) + 0.37 * float(k), 0.0).xyz;
    m = sqrt(m * m + 2.0 * (1.0 - weight * weight) * strength * strength * lostSlope[k]);
  }
  slope *= strength;
  return normalize(n - (slope - dot(slope, n) * n));
#else
  m = sqrt(m * m + 2.0 * strength * strength * (lostSlope.x + lostSlope.y));
  return n;
#endif
}
