// A texel of a surface buffer (render/surface_buffer.h), beside its depth. xyz: toward the outside, any length; on inner
// sides toward the eye. w: how well the place is known, 0 to 1, or the colour of a part; -1 less on inner sides.
vec4 outerSurface(vec3 normal, float known) { return vec4(normal, known); }

vec4 innerSurface(vec3 normal, float known) { return vec4(normal, -1.0 - known); }

bool isInner(float w) { return w < 0.0; }

float knownOf(float w) { return isInner(w) ? -1.0 - w : w; }
