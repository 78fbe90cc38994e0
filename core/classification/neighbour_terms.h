#pragma once

#include "core/classification/classification_options.h"
#include "core/classification/operator_sum.h"
#include "core/classification/smoothed.h"
#include "core/classification/tangential_operator.h"

namespace sonoskin {

// NeighbourTerms: K, all that couples voxels with their neighbours; solvers know the sum alone. A term more is its type here
// and its value in neighbourTerms().
using NeighbourTerms = OperatorSum<TangentialOperator>;

// neighbourTerms: K of the variational formulation, as strong as the options say.
NeighbourTerms neighbourTerms(std::shared_ptr<const Directions> directions,
                              const ClassificationOptions& options);
// The same, with the directions of the whole volume made first.
NeighbourTerms neighbourTerms(const Smoothed& smoothed, const ClassificationOptions& options);

}  // namespace sonoskin
