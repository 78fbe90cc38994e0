// Fills a surface buffer (surface/buffer.glsl) whose material is the place in the atlas. Little work here, see
// mesh/mesh.frag. w: from 0.5 (filled in) to 1 (measured), its negative on inner sides.
in vec4 normalIn;
in vec2 uvIn;

layout(location = 0) out vec4 normalAndSide;
layout(location = 1) out vec2 place;

void main() {
  normalAndSide = gl_FrontFacing ? normalIn : -normalIn;
  place = uvIn;
}
