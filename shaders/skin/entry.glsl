// Where light enters the body, in a light's map: a place in the atlas, above 0; of what the atlas does not show its normal,
// below 0; 0: nowhere.
bool isEntry(vec2 entry) { return entry.x != 0.0; }

bool isInAtlas(vec2 entry) { return entry.x > 0.0; }

// Unit normal to a point of the octahedron's net, -1 to 1, moved to -3 to -1.                          [Meyer et al. 2010]
vec2 entryFacing(vec3 n) {
  vec2 net = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
  vec2 folded = (1.0 - abs(net.yx)) * vec2(net.x < 0.0 ? -1.0 : 1.0, net.y < 0.0 ? -1.0 : 1.0);
  return (n.z < 0.0 ? folded : net) - 2.0;
}

vec3 facingOf(vec2 entry) {
  vec2 net = entry + 2.0;
  float z = 1.0 - abs(net.x) - abs(net.y), over = max(-z, 0.0);
  return normalize(vec3(net - over * vec2(net.x < 0.0 ? -1.0 : 1.0, net.y < 0.0 ? -1.0 : 1.0), z));
}
