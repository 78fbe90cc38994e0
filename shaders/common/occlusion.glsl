// What arrives of the light from all around, per channel, where the share `open` of it is not shut out: what shuts it out
// is of the same colour and in the same light. In folds light takes on that colour.
//   solves   E = open + albedo (1 - open) E             [as the fit of Jimenez et al. 2016 to 0.03, and never above 1]
vec3 reflectedOcclusion(float open, vec3 albedo) { return open / (1.0 - albedo * (1.0 - open) + 1e-4); }
