#pragma once

#include "core/mesh/repair/clean.h"
#include "core/pipeline/parameters.h"

namespace sonoskin {

// StageShare: a stage's word for people, and where in the progress of a run that goes to the mesh it ends.
struct StageShare {
  const char* name;
  double until;
};

// StageShares: of all stages, in the order of work.
struct StageShares {
  StageShare enhanced{"enhancement", 0.1};
  StageShare coarser{"coarser voxels", 0.12};  // in previews alone
  StageShare prepared{"low-pass", 0.15};
  StageShare classified{"classification", 0.5};
  StageShare points{"points", 0.6};
  StageShare evidence{"evidence", 0.61};
  StageShare face{"face", 0.65};
  StageShare fit{"fit", 0.8};
  StageShare pieces{"surface", 0.95};
  StageShare parts{"parts", 0.99};
  StageShare kept{"piece", 1};
  StageShare mesh{"clean", 1};
  StageShare print{"print", 1};
};

// sharesOf: a solid takes most of the time where one is made.
inline StageShares sharesOf(const Parameters& parameters) {
  StageShares shares;
  const double cleaned = parameters.print.form == PrintForm::none ? 1 : 0.85;
  const double kept = needsCleaning(parameters.mesh) ? 0.9 * cleaned : cleaned;
  for (StageShare* share : {&shares.pieces, &shares.parts, &shares.kept}) share->until *= kept;
  shares.mesh.until = cleaned;
  return shares;
}

}  // namespace sonoskin
