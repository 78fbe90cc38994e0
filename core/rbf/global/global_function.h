#pragma once

#include <memory>

#include "core/rbf/global/global_rbf.h"
#include "core/rbf/implicit_function.h"

namespace sonoskin {

// globalFunction: a global function as the iso-surface asks for it, on a lattice with the given cell, mm.
//   coverage   the same everywhere, above any limit: only the distance to the points says where the surface ends
//   lifetime   the function keeps the model
//   method     blocks of 20 cells are made when the surface first enters them, see GlobalBlock
//   cost       per block, centres times 216 kernels; 10k centres: 2 ms of one core
ImplicitFunction globalFunction(std::shared_ptr<const GlobalRbf> model, float cell);

}  // namespace sonoskin
