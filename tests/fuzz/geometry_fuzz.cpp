// The geometry of a stored volume, with whatever numbers a header may hold.
#include <cmath>

#include "core/io/stored_volume.h"
#include "tests/fuzz/stored_volumes.h"

using namespace sonoskin;

namespace {

void claimStraight(const Geometry& g) {
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      fuzz::claim(std::abs(glm::dot(g.direction[a], g.direction[b]) - (a == b)) < 1e-9,
                  "axes are orthonormal");
  for (const glm::dvec3& corner : {glm::dvec3(0), glm::dvec3(g.dims - 1)}) {
    const glm::dvec3 back = g.toIndex(g.toWorld(corner));
    fuzz::claim(glm::distance(back, corner) < 0.01, "a voxel's place leads back to it");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers numbers({data, size});
  StoredVolume stored = fuzz::storedVolume(numbers);
  fuzz::attempt([&] {
    checkGeometry(stored, "a.nrrd");
    claimStraight(stored.geometry);
  });
  return 0;
}
