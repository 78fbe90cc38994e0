#pragma once

#include <memory>

#include "core/base/progress.h"
#include "core/classification/classification_options.h"
#include "core/classification/classify.h"
#include "core/classification/scaled_system.h"
#include "core/volume/volume.h"

namespace sonoskin {

// LiveClassifier: classifies one volume again and again while sliders move: keeps what depends on the volume
// alone, starts from the last answer, and solves to kLiveTolerance by the fast solver.
//   memory   13 bytes per voxel beside the volume, what smooth() made of it and the answer: 25 in all
//   threads  one at a time
class LiveClassifier {
 public:
  // Interactive results lie within 0.02 of the converged ones.
  static constexpr double kLiveTolerance = 2e-3;

  LiveClassifier(std::shared_ptr<const Volume<float>> volume, std::shared_ptr<const Smoothed> smoothed);

  // classify: as classify() in classify.h, but for the tolerance: kLiveTolerance, or options' if that is larger.
  //   options  the variational formulation; always the same directionScale
  //   errors   Cancelled; the next call then starts afresh
  std::shared_ptr<const Volume<float>> classify(const ClassificationOptions& options,
                                                const Progress& progress = {});

  const Smoothed* smoothed() const { return smoothed_.get(); }

 private:
  std::shared_ptr<const Volume<float>> volume_;
  std::shared_ptr<const Smoothed> smoothed_;
  std::shared_ptr<const Directions> directions_{};  // made when they are first needed
  ScaledSystem system_;
  LargeArray<float> scratch_;
  std::shared_ptr<const Volume<float>> last_;  // the answer for system_, or empty
};

}  // namespace sonoskin
