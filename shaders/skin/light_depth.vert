layout(location = 0) in vec3 position;
layout(location = 2) in vec2 atlasUv;

uniform mat4 viewProjection;

out vec2 uv;

void main() {
  uv = atlasUv;
  gl_Position = viewProjection * vec4(position, 1.0);
}
