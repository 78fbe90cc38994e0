layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float known;

uniform mat4 viewProjection;
uniform vec4 clip;  // see render/clip_plane.h

out vec4 normalAndKnown;

void main() {
  normalAndKnown = vec4(normal, known);
  gl_ClipDistance[0] = dot(clip, vec4(position, 1.0));
  gl_Position = viewProjection * vec4(position, 1.0);
}
