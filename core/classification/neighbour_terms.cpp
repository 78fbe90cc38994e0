#include "core/classification/neighbour_terms.h"

#include "core/classification/data_term.h"

namespace sonoskin {

NeighbourTerms neighbourTerms(const Smoothed& smoothed, const ClassificationOptions& options) {
  return NeighbourTerms(TangentialOperator(smoothed.directions, absoluteBeta(options)));
}

}  // namespace sonoskin
