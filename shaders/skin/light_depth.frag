// A light's view of the surface: where in the atlas lies what it sees.                [GPU Gems 3, ch. 14.5.4]
in vec2 uv;

layout(location = 0) out vec2 place;

void main() { place = uv; }
