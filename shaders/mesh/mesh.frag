// Fills a surface buffer, see surface/shade.frag. Little work here, much there: small triangles make a software
// rasteriser run this shader for many more pixels than it keeps.
in vec4 normalAndSeen;

layout(location = 0) out vec4 surface;

void main() { surface = gl_FrontFacing ? normalAndSeen : vec4(-normalAndSeen.xyz, -1.0 - normalAndSeen.w); }
