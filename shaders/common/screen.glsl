// The screen's pixels as rays: a sample at uv and distance d (mm along the view's middle) lies at
// eye + d * rayAt(uv). Depth is that of a perspective projection.
uniform vec3 eye;
uniform vec3 viewCentre, viewRight, viewUp;  // the middle (unit), and what the edges add
uniform vec2 depthTerms;                     // d = depthTerms.x / (depthTerms.y - depth)

vec3 rayAt(vec2 uv) {
  vec2 ndc = 2.0 * uv - 1.0;
  return viewCentre + ndc.x * viewRight + ndc.y * viewUp;
}

float distanceOf(float depth) { return depthTerms.x / (depthTerms.y - depth); }
