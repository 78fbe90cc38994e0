layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float known;

uniform mat4 viewProjection;

out vec4 normalAndKnown;

void main() {
  normalAndKnown = vec4(normal, known);
  gl_Position = viewProjection * vec4(position, 1.0);
}
