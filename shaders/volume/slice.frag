// One slice of a volume, sRGB-encoded. Variants: OVERLAY, TINT, ERASED.
in vec2 uv;

uniform ivec2 size;                                // of the picture, pixels
uniform sampler3D volume;
uniform vec3 volumeCorner, volumeRight, volumeDown;  // voxel indices: the upper left corner, and per pixel
uniform ivec3 volumeDims;                          // 0: there is no volume
uniform vec2 window;                               // shown = value * x + y
uniform vec2 cursor;                               // pixels from the upper left corner
uniform vec3 horizontalColour, verticalColour;     // of the cross-hair's lines
uniform vec4 box;                                  // left, top, right, bottom; pixels
#ifdef ERASED
uniform sampler3D erased;                          // bytes: 0 or not
uniform vec3 erasedCorner, erasedRight, erasedDown;
uniform ivec3 erasedDims;
uniform vec3 erasedColour;
#endif
#ifdef OVERLAY
uniform sampler3D overlay;
uniform vec3 overlayCorner, overlayRight, overlayDown;
uniform ivec3 overlayDims;
uniform vec2 overlayWindow;
uniform vec3 overlayColour;
uniform float overlayOpacity;
#endif
#ifdef TINT
uniform sampler3D tint;
uniform vec3 tintCorner, tintRight, tintDown;
uniform ivec3 tintDims;
uniform vec2 tintWindow;
uniform vec3 tintColour;
uniform float tintOpacity;
#endif

layout(location = 0) out vec4 colour;

const vec3 outsideColour = vec3(0.055, 0.06, 0.07), boxColour = vec3(0.29, 0.67, 0.75);

bool contains(vec3 index, ivec3 dims) {
  return all(greaterThan(index, vec3(-0.5))) && all(lessThan(index, vec3(dims) - 0.5));
}

void main() {
  vec2 pixel = vec2(uv.x, 1.0 - uv.y) * vec2(size);
  vec3 index = volumeCorner + pixel.x * volumeRight + pixel.y * volumeDown;
  float value = texture(volume, (index + 0.5) / vec3(max(volumeDims, 1))).r;
  vec3 shown = vec3(clamp(value * window.x + window.y, 0.0, 1.0));
  bool inBox = all(greaterThan(pixel, box.xy)) && all(lessThan(pixel, box.zw));
  shown = contains(index, volumeDims) ? shown * (inBox ? 1.0 : 0.4) : outsideColour;
#ifdef TINT
  vec3 tinted = tintCorner + pixel.x * tintRight + pixel.y * tintDown;
  float strength = texture(tint, (tinted + 0.5) / vec3(tintDims)).r * tintWindow.x + tintWindow.y;
  strength = contains(tinted, tintDims) ? clamp(strength, 0.0, 1.0) * tintOpacity : 0.0;
  shown = mix(shown, tintColour, strength);
#endif
#ifdef OVERLAY
  vec3 place = overlayCorner + pixel.x * overlayRight + pixel.y * overlayDown;
  float over = texture(overlay, (place + 0.5) / vec3(overlayDims)).r * overlayWindow.x + overlayWindow.y;
  over = contains(place, overlayDims) ? clamp(over, 0.0, 1.0) * overlayOpacity : 0.0;
  shown = mix(shown, overlayColour, over);
#endif
#ifdef ERASED
  vec3 gone = erasedCorner + pixel.x * erasedRight + pixel.y * erasedDown;
  float mark = 255.0 * texture(erased, (gone + 0.5) / vec3(erasedDims)).r;
  shown = contains(gone, erasedDims) && mark > 0.5 ? mix(shown, erasedColour, 0.5) : shown;
#endif
  vec4 side = abs(pixel.xyxy - box);
  bool onSide = min(min(side.x, side.y), min(side.z, side.w)) <= 0.5 &&
                all(greaterThan(pixel, box.xy - 0.6)) && all(lessThan(pixel, box.zw + 0.6));
  shown = onSide ? boxColour : shown;
  vec2 away = abs(pixel - cursor);
  // The middle stays free, so that what the cursor points at can be seen.
  float free = max(away.x, away.y) < 8.0 ? 0.0 : 0.75;
  shown = floor(pixel.y) == floor(cursor.y) ? mix(shown, horizontalColour, free) : shown;
  shown = floor(pixel.x) == floor(cursor.x) ? mix(shown, verticalColour, free) : shown;
  colour = vec4(shown, 1.0);
}
