#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/document/input.h"
#include "app/document/step_range.h"
#include "core/pipeline/pipeline.h"

namespace sonoskin {

// StepSurface: what was made of one time step, counted from 1.
struct StepSurface {
  int time = 1;
  Scan scan;
  Results results;
};
using StepTaker = std::function<void(const StepSurface& surface, const Progress& progress)>;

// NoSurface: a time step of which no surface can be made, and the sentence that says why.
struct NoSurface {
  int time = 1;
  std::string why;
};

// StepLoader: reads one time step, counted from 1.
using StepLoader = std::function<Scan(int time, const Progress& progress)>;

// makeSurfaces: the surfaces of time steps, one after another with the same parameters; one at a time is in memory. A step
// of which none can be made is left out.
//   errors  Error: the steps are not there, the file cannot be read, no step has a surface; what `take` throws; Cancelled
std::vector<NoSurface> makeSurfaces(const StepLoader& load, const Parameters& parameters, StepRange steps,
                                    const StepTaker& take, const Progress& progress = {});

}  // namespace sonoskin
