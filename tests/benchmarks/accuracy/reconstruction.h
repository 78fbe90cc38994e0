#pragma once

#include "core/pipeline/parameters.h"

namespace sonoskin::accuracy {

// printReconstructionTables: as Markdown, the mesh held against the truth for three noise levels of the simulated scan and
// two spheres, with and without weights, sub-voxel positions and confidence, and for several values of the smoothness.
//   parameters   what else is changed
void printReconstructionTables(const Parameters& parameters);

}  // namespace sonoskin::accuracy
