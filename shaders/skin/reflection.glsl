// The surface's reflection: microfacets of roughness m with Beckmann's distribution.
uniform sampler2D specularTable;  // x: directional albedo over cosine and roughness, y: its mean; for rho_s = 1
const float f0 = 0.028;           // index of refraction 1.4
const float tableLeast = 0.05, tableMost = 0.65;

vec2 reflected(float cosine, float m) {
  vec2 size = vec2(textureSize(specularTable, 0));
  vec2 place = vec2(clamp(cosine, 0.0, 1.0), clamp((m - tableLeast) / (tableMost - tableLeast), 0.0, 1.0));
  return textureLod(specularTable, (place * (size - 1.0) + 0.5) / size, 0.0).rg;
}

float schlick(float f, float cosine) {
  float x = 1.0 - clamp(cosine, 0.0, 1.0);
  float x2 = x * x;
  return f + (1.0 - f) * x2 * x2 * x;
}

// pi f cos of one lobe.                                        [Kelemen, Szirmay-Kalos 2001; theory/skin.md, 8.1]
float lobe(vec3 n, vec3 toEye, vec3 l, float m, float f) {
  vec3 sum = toEye + l;
  float squared = max(dot(sum, sum), 1e-4);
  vec3 h = sum * inversesqrt(squared);
  float nh = clamp(dot(n, h), 1e-3, 1.0), nh2 = nh * nh;
  float d = exp((nh2 - 1.0) / (m * m * nh2)) / (m * m * nh2 * nh2);
  return max(dot(n, l), 0.0) * d * schlick(f, dot(toEye, h)) / squared;
}
