// The colours of parts, see render/parts_mesh.h: number 0 is skin; from 12 on they are dimmed.
const vec3 partColours[12] =
    vec3[](vec3(0.70, 0.44, 0.32), vec3(0.07, 0.20, 0.60), vec3(0.07, 0.36, 0.09), vec3(0.62, 0.11, 0.05),
           vec3(0.30, 0.10, 0.52), vec3(0.66, 0.42, 0.03), vec3(0.04, 0.38, 0.40), vec3(0.62, 0.14, 0.33),
           vec3(0.24, 0.24, 0.05), vec3(0.14, 0.08, 0.50), vec3(0.28, 0.50, 0.08), vec3(0.36, 0.05, 0.13));

vec3 partColour(float code) {
  int number = int(64.0 * code + 0.5);
  vec3 bright = partColours[number % 12];
  return number < 12 ? bright : mix(vec3(0.06, 0.065, 0.075), bright, 0.12);
}
