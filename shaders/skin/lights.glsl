// The lights on the skin and their depth maps. Colours are irradiance / pi: a white surface that faces the light shows them.
// KIND: of light 0; 0 far, 1 near, 2 inside the body. Lights 1 and 2 are far.
struct Light {
  vec3 position;   // far: unit direction toward it; near and inside: world mm
  vec3 colour;
  float reach;     // mm; near and inside: where the colour holds
  float softness;  // tangent of its radius as seen from the skin
  float shadows;   // 1 where it has a depth map
  mat4 toMap;      // world -> 0 .. 1 of its depth map
  vec2 terms;      // near: distance = terms.x / (terms.y - depth); far: distance = terms.x * depth; mm
  float texel;     // mm of its depth map, at the surface's middle
};
uniform Light lights[3];
uniform vec3 environment[9];  // radiance, spherical harmonics

bool isFar(int i) { return i > 0 || KIND == 0; }

vec3 toLight(int i, vec3 p) { return isFar(i) ? lights[i].position : normalize(lights[i].position - p); }

// What arrives at p where nothing is in the way.                                        [theory/skin.md, 4.1]
vec3 arriving(int i, vec3 p) {
  if (isFar(i)) return lights[i].colour;
  vec3 way = lights[i].position - p;
  float squared = dot(way, way), reach2 = lights[i].reach * lights[i].reach, least2 = 0.01 * reach2;  // a lamp is no point
  float window = clamp(1.0 - squared * squared / (1e4 * reach2 * reach2), 0.0, 1.0);
  return lights[i].colour * (reach2 + least2) / (squared + least2) * window * window;
}

float mapDistance(int i, float depth) {
  return isFar(i) ? lights[i].terms.x * depth : lights[i].terms.x / (lights[i].terms.y - depth);
}

// Radiance from direction d, smoothed to second order.
vec3 radiance(vec3 d) {
  return max(0.282095 * environment[0] + 0.488603 * (d.y * environment[1] + d.z * environment[2] + d.x * environment[3]) +
                 1.092548 * (d.x * d.y * environment[4] + d.y * d.z * environment[5] + d.x * d.z * environment[7]) +
                 0.315392 * (3.0 * d.z * d.z - 1.0) * environment[6] +
                 0.546274 * (d.x * d.x - d.y * d.y) * environment[8],
             vec3(0.0));
}

// Irradiance / pi of a surface with normal n from all around.      [Ramamoorthi, Hanrahan 2001: A_l / pi = 1, 2/3, 1/4]
vec3 irradianceAround(vec3 n) {
  return max(0.282095 * environment[0] +
                 (2.0 / 3.0) * 0.488603 * (n.y * environment[1] + n.z * environment[2] + n.x * environment[3]) +
                 0.25 * (1.092548 * (n.x * n.y * environment[4] + n.y * n.z * environment[5] + n.x * n.z * environment[7]) +
                         0.315392 * (3.0 * n.z * n.z - 1.0) * environment[6] +
                         0.546274 * (n.x * n.x - n.y * n.y) * environment[8]),
             vec3(0.0));
}
