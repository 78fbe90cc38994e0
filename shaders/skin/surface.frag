// Little work here, see mesh/mesh.frag: the normal and the place in the atlas; w: from 0.5 (filled in) to 1
// (measured), less than 0 on inner sides.
in vec4 normalIn;
in vec2 uvIn;

layout(location = 0) out vec4 normalAndSide;
layout(location = 1) out vec2 place;

void main() {
  normalAndSide = gl_FrontFacing ? normalIn : -normalIn;
  place = uvIn;
}
