// The ray of a pixel through a volume. Positions are voxel indices (a voxel's centre is at whole numbers); t is the
// depth along the view's middle in mm, so rays of a perspective are not of unit length. Variants: ERASED; BEHIND: rays end at
// a surface that is drawn already.
uniform float perspective;                 // 1: rays meet at the eye; 0: they are parallel (a far light's view)
uniform vec3 eyeIndex;                     // the eye, in voxel indices
uniform vec3 rayCentre, rayRight, rayUp;   // voxel indices: the middle per mm, and what the edges add
uniform vec3 viewCentre, viewRight, viewUp;  // the same in world mm
uniform ivec3 dims;
uniform vec3 boxMin, boxMax;               // the part that is shown, in voxel indices
uniform float stepLength;                  // mm along the ray
uniform sampler3D bricks;
uniform vec4 clip;                         // kept is where dot(clip.xyz, index) + clip.w >= 0

#ifdef ERASED
uniform sampler3D erased;                  // bytes: 0 or not
uniform vec3 erasedScale, erasedOffset;    // from voxel indices to places in it
#endif

#ifdef BEHIND
uniform sampler2D behindDepth;             // of the surface, as the same camera sees it
uniform vec2 behindTerms;                  // t = behindTerms.x / (behindTerms.y - depth)
#endif

const float brickSide = 8.0;

struct Ray {
  vec3 origin;      // voxel indices
  vec3 direction;   // voxel indices per unit of t
  float from, to;   // where it enters and leaves the box; from >= to where it misses
  float step;       // stepLength in units of t
  bool cut;         // whether it enters where the plane cuts
};

vec3 nonZero(vec3 v) { return mix(v, vec3(1e-9), lessThan(abs(v), vec3(1e-9))); }

Ray makeRay(vec2 uv) {
  vec2 ndc = 2.0 * uv - 1.0;
  vec3 aside = ndc.x * rayRight + ndc.y * rayUp;
  Ray ray;
  ray.origin = eyeIndex + (1.0 - perspective) * aside;
  ray.direction = rayCentre + perspective * aside;
  ray.step = stepLength / length(viewCentre + perspective * (ndc.x * viewRight + ndc.y * viewUp));
  vec3 inverse = 1.0 / nonZero(ray.direction);
  vec3 t0 = (boxMin - ray.origin) * inverse, t1 = (boxMax - ray.origin) * inverse;
  vec3 enter = min(t0, t1), leave = max(t0, t1);
  ray.from = max(max(enter.x, max(enter.y, enter.z)), 0.0);
  ray.to = min(leave.x, min(leave.y, leave.z));
  float along = dot(clip.xyz, ray.direction);
  float place = -(dot(clip.xyz, ray.origin) + clip.w) / (abs(along) < 1e-9 ? 1e-9 : along);
  ray.cut = along > 0.0 && place > ray.from;
  ray.from = along < 0.0 ? ray.from : max(ray.from, place);
  ray.to = along < 0.0 ? min(ray.to, place) : ray.to;
#ifdef BEHIND
  float depth = texelFetch(behindDepth, ivec2(uv * vec2(textureSize(behindDepth, 0))), 0).r;
  ray.to = depth < 1.0 ? min(ray.to, behindTerms.x / (behindTerms.y - depth)) : ray.to;
#endif
  return ray;
}

bool isErased(vec3 index) {
#ifdef ERASED
  return 255.0 * texture(erased, index * erasedScale + erasedOffset).r > 0.5;
#else
  return false;
#endif
}

float brickMaximum(vec3 index) { return texelFetch(bricks, ivec3(index / brickSide), 0).r; }

// How much farther in t the ray leaves the brick that holds `index`.
float brickExit(vec3 index, vec3 direction) {
  vec3 low = floor(index / brickSide) * brickSide;
  vec3 planes = mix(low, low + brickSide, greaterThan(direction, vec3(0.0)));
  vec3 t = (planes - index) / nonZero(direction);
  return max(min(t.x, min(t.y, t.z)), 0.0);
}

// The next sample position after an empty brick: positions stay on the ray's own lattice, or the leap would show.
float leap(Ray ray, float t, vec3 index, float offset) {
  float exit = t + brickExit(index, ray.direction);
  float n = ceil((exit - ray.from) / ray.step - offset);
  return max(ray.from + (n + offset) * ray.step, t + ray.step);
}
