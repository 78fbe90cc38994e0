layout(location = 0) in vec3 position;

uniform mat4 viewProjection;
uniform vec4 clip;  // see render/clip_plane.h

void main() {
  gl_ClipDistance[0] = dot(clip, vec4(position, 1.0));
  gl_Position = viewProjection * vec4(position, 1.0);
}
