#include "core/pipeline/live_solver.h"

namespace sonoskin {

std::shared_ptr<const Volume<float>> LiveSolver::classify(const ClassifierInput& input,
                                                          const ClassificationOptions& options,
                                                          const Progress& progress) {
  const std::shared_ptr<const Prepared>& prepared = input.prepared.value;
  if (options.formulation != Formulation::variational)
    return std::make_shared<const Volume<float>>(
        sonoskin::classify(*input.volume.value, prepared->smoothed, options, progress));
  if (!classifier_ || prepared_ != input.prepared.key) {
    forget();  // before the next one takes as much
    classifier_ = std::make_unique<LiveClassifier>(
        input.volume.value, std::shared_ptr<const Smoothed>(prepared, &prepared->smoothed));
    prepared_ = input.prepared.key;
  }
  return classifier_->classify(options, progress);
}

}  // namespace sonoskin
