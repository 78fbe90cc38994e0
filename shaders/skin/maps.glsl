// The surface as pictures over its atlas, see core/mesh/atlas/atlas_maps.h.
uniform sampler2D positionMap, normalMap, openMap;
uniform sampler2D albedoMap;  // rgb
uniform sampler2D finishMap;  // roughness, gloss, wetness, vernix
