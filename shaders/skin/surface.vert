layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 atlasUv;

uniform mat4 viewProjection;

out vec3 normalIn;
out vec2 uvIn;

void main() {
  normalIn = normal;
  uvIn = atlasUv;
  gl_Position = viewProjection * vec4(position, 1.0);
}
