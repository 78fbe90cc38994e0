#pragma once

#include "core/volume/volume.h"

namespace sonoskin {

// Slab: the slices first <= k < last of a volume.
struct Slab {
  int first, last;
};

// slabGeometry: of these slices as a volume of their own.
inline Geometry slabGeometry(Geometry geometry, const Slab& slab) {
  geometry.origin = geometry.toWorld(glm::dvec3(0, 0, slab.first));
  geometry.dims.z = slab.last - slab.first;
  return geometry;
}

}  // namespace sonoskin
