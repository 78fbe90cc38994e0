#include "core/classification/live_classifier.h"

#include <algorithm>
#include <utility>

#include "core/classification/chebyshev.h"
#include "core/classification/neighbour_terms.h"

namespace sonoskin {

LiveClassifier::LiveClassifier(std::shared_ptr<const Volume<float>> volume,
                               std::shared_ptr<const Smoothed> smoothed)
    : volume_(std::move(volume)), smoothed_(std::move(smoothed)), scratch_(volume_->data.size()) {}

std::shared_ptr<const Volume<float>> LiveClassifier::classify(const ClassificationOptions& options,
                                                              const Progress& progress) {
  const auto before = std::exchange(last_, nullptr);  // of no use for a system that is half rebuilt
  if (!directions_)
    directions_ = std::make_shared<const Directions>(
        cellDirections(smoothed_->lowPassed, options.directionScale, progress.cancelOnly()));
  const NeighbourTerms k = neighbourTerms(directions_, options);
  auto u = Volume<float>::unset(volume_->geometry);
  scaleSystem({*volume_, smoothed_->lowPassed, options, smoothed_->levels}, k,
              before ? before->data.data() : nullptr, system_, u.data.data(), progress.part(0, 0.2));
  const double tolerance = std::max(kLiveTolerance, options.tolerance);
  const FastSolution solution = solveFast(k, system_, tolerance, u.data, scratch_, progress.part(0.2, 0.9));
  if (!solution.converged)
    return std::make_shared<const Volume<float>>(
        sonoskin::classify(*volume_, *smoothed_, options, progress.part(0.9, 1)));
  clampToTarget(u, options);
  last_ = std::make_shared<const Volume<float>>(std::move(u));
  progress.update(1);
  return last_;
}

}  // namespace sonoskin
