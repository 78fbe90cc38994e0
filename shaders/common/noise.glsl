// Interleaved gradient noise in [0,1): fixed for a pixel, well spread over every 3x3 pixels. [Jimenez 2014]
float pixelNoise(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

// Point i of n evenly filling the unit disc (Vogel's spiral), turned by `angle`.
vec2 discPoint(int i, int n, float angle) {
  float radius = sqrt((float(i) + 0.5) / float(n));
  float theta = float(i) * 2.39996323 + angle;
  return radius * vec2(cos(theta), sin(theta));
}
