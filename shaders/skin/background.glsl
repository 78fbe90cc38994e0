// What is behind the skin, display-linear: a soft gradient.
uniform vec3 backgroundTop, backgroundBottom;

vec3 background(vec2 uv) {
  float height = uv.y + 0.25 * (uv.x - 0.5) * (uv.x - 0.5);
  return mix(backgroundBottom, backgroundTop, smoothstep(0.0, 1.0, height));
}
