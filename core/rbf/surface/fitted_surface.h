#pragma once

#include <cstddef>
#include <functional>

#include "core/base/progress.h"
#include "core/rbf/compact/csrbf_model.h"
#include "core/rbf/global/global_options.h"
#include "core/rbf/implicit_function.h"
#include "core/rbf/reconstruction_options.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// FittedSurface: what a fit leaves behind, whichever method made it.
//   function   makes what extractIsoSurface asks for, for a lattice with the given cell, mm
//   report     of a global function: every point weighs the same
struct FittedSurface {
  std::function<ImplicitFunction(float cell)> function;
  std::size_t centres = 0;
  std::size_t bytes = 0;
  FitReport report;
};

// fitSurface: an implicit function through oriented points, by options.method.
//   cost, errors, threads   see fitCsrbf and fitGlobal
FittedSurface fitSurface(const SurfacePoints& points, const ReconstructionOptions& options,
                         const GlobalOptions& global, const Progress& progress = {});

}  // namespace sonoskin
