// A light's view of the surface: where in the atlas lies what it sees.                [GPU Gems 3, ch. 14.5.4]
// Variant: HIDDEN: of what is not in the atlas, which way it faces.
#include "skin/entry.glsl"
#ifdef HIDDEN
in vec3 normalIn;
#else
in vec2 uv;
#endif

layout(location = 0) out vec2 place;

void main() {
#ifdef HIDDEN
  place = entryFacing(normalize(normalIn));
#else
  place = uv;
#endif
}
