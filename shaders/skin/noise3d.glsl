// Noise as a function of the place in mm: no seams, no texture files.
uint scramble(uvec3 v) {  // [Jarzynski, Olano 2020, pcg3d, first component]
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  return v.x;
}

float cornerValue(ivec3 corner) { return float(scramble(uvec3(corner))) * (2.0 / 4294967295.0) - 1.0; }

// Smooth noise between -1 and 1, one bump per unit.
float noise(vec3 p) {
  ivec3 cell = ivec3(floor(p));
  vec3 t = fract(p);
  t = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  float corners[8];
  for (int i = 0; i < 8; ++i) corners[i] = cornerValue(cell + ivec3(i & 1, (i >> 1) & 1, i >> 2));
  return mix(mix(mix(corners[0], corners[1], t.x), mix(corners[2], corners[3], t.x), t.y),
             mix(mix(corners[4], corners[5], t.x), mix(corners[6], corners[7], t.x), t.y), t.z);
}

// Three octaves, period `length` mm for the largest.
float fractal(vec3 p, float length) {
  vec3 q = p / length;
  return (noise(q) + 0.5 * noise(2.03 * q + 17.0) + 0.25 * noise(4.1 * q + 43.0)) / 1.3;
}
