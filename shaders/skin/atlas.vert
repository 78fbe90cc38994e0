// The parts of an atlas that show something.
layout(location = 0) in vec2 place;  // 0 to 1 over the atlas

void main() { gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0); }
