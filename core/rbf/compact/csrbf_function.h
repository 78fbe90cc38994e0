#pragma once

#include "core/rbf/compact/csrbf_model.h"
#include "core/rbf/implicit_function.h"

namespace sonoskin {

// csrbfFunction: a fitted model as the iso-surface asks for it, on a lattice with the given cell, mm.
//   lifetime   the function holds a copy of the centres: the model may go
//   cost       the centres are listed by cells of 16 nodes; a brick costs 64 places times the 15 to 30 supports around it
ImplicitFunction csrbfFunction(const CsrbfModel& model, float cell);

}  // namespace sonoskin
