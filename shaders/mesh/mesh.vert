layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float visibility;

uniform mat4 viewProjection;
uniform mat4 shadowMatrix;  // world -> shadow map, each axis 0 to 1
uniform float shadowOffset;  // mm along the normal, against a surface shadowing itself
uniform vec3 keyDirection;

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 shadowPosition;
out float seen;

void main() {
  float slope = 1.0 - abs(dot(normal, keyDirection));
  worldPosition = position;
  worldNormal = normal;
  shadowPosition = (shadowMatrix * vec4(position + normal * shadowOffset * (0.3 + slope), 1.0)).xyz;
  seen = visibility;
  gl_Position = viewProjection * vec4(position, 1.0);
}
