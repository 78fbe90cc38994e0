// Fills a surface buffer. Little work here, much where it is shaded: small triangles make a software rasteriser run this
// shader for many more pixels than it keeps.
#include "surface/buffer.glsl"

in vec4 normalAndKnown;

layout(location = 0) out vec4 surface;

void main() {
  vec3 normal = normalAndKnown.xyz;
  float known = normalAndKnown.w;
  surface = gl_FrontFacing ? outerSurface(normal, known) : innerSurface(-normal, known);
}
