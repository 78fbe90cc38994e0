#pragma once

#include "core/io/stored_volume.h"
#include "tests/fuzz/fuzz_input.h"

namespace sonoskin::fuzz {

// storedVolume: of 21 numbers: dims (int32), spacing, origin and direction (float64), then one byte each for the type, the
// numbers per voxel and whether the spacing is known.
inline StoredVolume storedVolume(Numbers& numbers) {
  StoredVolume stored;
  Geometry& g = stored.geometry;
  for (int a = 0; a < 3; ++a) g.dims[a] = numbers.next<std::int32_t>();
  for (int a = 0; a < 3; ++a) g.spacing[a] = numbers.next<double>();
  for (int a = 0; a < 3; ++a) g.origin[a] = numbers.next<double>();
  for (int a = 0; a < 3; ++a)
    for (int r = 0; r < 3; ++r) g.direction[a][r] = numbers.next<double>();
  stored.type = NumberType(numbers.between(0, int(NumberType::float64)));
  stored.components = numbers.between(0, 5);
  stored.spacingKnown = numbers.between(0, 1) == 1;
  return stored;
}

}  // namespace sonoskin::fuzz
