layout(location = 0) in vec3 position;

uniform mat4 shadowProjection;

void main() { gl_Position = shadowProjection * vec4(position, 1.0); }
