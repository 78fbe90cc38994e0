// What arrives of the light from all around, per channel: light that is reflected in folds takes on the surface's
// colour. [fit of Jimenez et al. 2016]
vec3 reflectedOcclusion(float arriving, vec3 albedo) {
  vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
  return max(vec3(arriving), ((arriving * a + b) * arriving + c) * arriving);
}
