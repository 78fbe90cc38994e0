#include "core/classification/neighbour_terms.h"

#include "core/classification/data_term.h"

namespace sonoskin {

NeighbourTerms neighbourTerms(std::shared_ptr<const Directions> directions,
                              const ClassificationOptions& options) {
  return NeighbourTerms(TangentialOperator(std::move(directions), absoluteBeta(options)));
}

NeighbourTerms neighbourTerms(const Smoothed& smoothed, const ClassificationOptions& options) {
  return neighbourTerms(
      std::make_shared<const Directions>(cellDirections(smoothed.lowPassed, options.directionScale)),
      options);
}

}  // namespace sonoskin
