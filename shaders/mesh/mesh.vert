layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float visibility;

uniform mat4 viewProjection;

out vec4 normalAndSeen;

void main() {
  normalAndSeen = vec4(normal, visibility);
  gl_Position = viewProjection * vec4(position, 1.0);
}
