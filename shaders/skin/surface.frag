// Little work here, see mesh/mesh.frag: the normal and the place in the atlas; inner sides have w = -1.
in vec3 normalIn;
in vec2 uvIn;

layout(location = 0) out vec4 normalAndSide;
layout(location = 1) out vec2 place;

void main() {
  normalAndSide = gl_FrontFacing ? vec4(normalIn, 1.0) : vec4(-normalIn, -1.0);
  place = uvIn;
}
