#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>

#include "core/pipeline/live_solver.h"

namespace sonoskin {

// VolumeSlice: the voxels whose index along `axis` (0 i, 1 j, 2 k) is `at`.
struct VolumeSlice {
  int axis = 0, at = 0;
};

// SliceSolver: classifies the three slices of a volume that are looked at, each in a slab of its own: the equation couples
// neighbours, but what lies farther than a few voxels does not change a slice that a person looks at. Keeps the slabs.
class SliceSolver {
 public:
  // classify: u in one slice, one voxel thick: within 0.01 of what the whole volume would give in the mean, and within
  // 0.2 anywhere.
  //   options  the variational formulation
  //   slice    brought into the volume
  //   cost     of all three an eighth of the whole volume's, of 467x255x124 voxels
  //   errors   Cancelled
  std::shared_ptr<const Volume<float>> classify(const ClassifierInput& input,
                                                const ClassificationOptions& options,
                                                const VolumeSlice& slice, const Progress& progress = {});
  // forget: gives its memory back.
  void forget() { *this = {}; }

 private:
  struct Slab {
    LiveSolver solver;
    ClassifierInput input;  // cut out of the volume
    Key key;                // of what it was cut out of, and where
    glm::ivec3 first{0};
  };
  std::array<Slab, 3> slabs_{};
};

}  // namespace sonoskin
