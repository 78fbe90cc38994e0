layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 atlasUv;
layout(location = 3) in float measured;

uniform mat4 viewProjection;
uniform vec4 clip;  // see render/clip_plane.h

out vec4 normalIn;
out vec2 uvIn;

void main() {
  normalIn = vec4(normal, 0.5 + 0.5 * measured);
  uvIn = atlasUv;
  gl_ClipDistance[0] = dot(clip, vec4(position, 1.0));
  gl_Position = viewProjection * vec4(position, 1.0);
}
