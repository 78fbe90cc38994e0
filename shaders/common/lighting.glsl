// Three lights and a hemisphere. Light colours are irradiance / pi, so that diffuse = albedo * colour * cosine.
uniform vec3 keyDirection, fillDirection, rimDirection;  // unit, toward the light
uniform vec3 keyColour, fillColour, rimColour;
uniform vec3 skyColour, groundColour, skyDirection;

vec3 hemisphere(vec3 normal) { return mix(groundColour, skyColour, 0.5 + 0.5 * dot(normal, skyDirection)); }

float luminance(vec3 colour) { return dot(colour, vec3(0.2126, 0.7152, 0.0722)); }

// Light that wraps around the terminator by `wrap` per channel, keeping the sum over the sphere.
vec3 wrapped(float cosine, vec3 wrap) {
  vec3 lit = max((cosine + wrap) / (1.0 + wrap), 0.0);
  return lit / (1.0 + wrap);
}

// Specular reflection of one light of colour / pi: GGX with Smith's joint visibility and Schlick's Fresnel term.
float specular(vec3 normal, vec3 toEye, vec3 toLight, float roughness, float f0) {
  vec3 halfway = normalize(toEye + toLight);
  float nl = max(dot(normal, toLight), 0.0), nv = max(dot(normal, toEye), 1e-3);
  float nh = max(dot(normal, halfway), 0.0), vh = max(dot(toEye, halfway), 0.0);
  float a2 = roughness * roughness * roughness * roughness;
  float d = nh * nh * (a2 - 1.0) + 1.0;
  float distribution = a2 / (d * d);  // times 1/pi, which the light's colour holds
  float visibility = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2) + 1e-5);
  float fresnel = f0 + (1.0 - f0) * pow(1.0 - vh, 5.0);
  return nl * distribution * visibility * fresnel;
}
