layout(location = 0) in vec3 position;
#ifdef HIDDEN
layout(location = 1) in vec3 normal;
#else
layout(location = 2) in vec2 atlasUv;
#endif

uniform mat4 viewProjection;

#ifdef HIDDEN
out vec3 normalIn;
#else
out vec2 uv;
#endif

void main() {
#ifdef HIDDEN
  normalIn = normal;
#else
  uv = atlasUv;
#endif
  gl_Position = viewProjection * vec4(position, 1.0);
}
