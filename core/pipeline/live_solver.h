#pragma once

#include <memory>

#include "core/classification/live_classifier.h"
#include "core/pipeline/prepared.h"
#include "core/pipeline/stage_run.h"

namespace sonoskin {

// ClassifierInput: what classification begins from: the scan's own volume or the enhanced one, and what is known of it.
struct ClassifierInput {
  Keyed<Volume<float>> volume;
  Keyed<Prepared> prepared;
};

// LiveSolver: the classifier of one volume, as long as what was prepared from it stays the same. Its system is no result
// of a stage, and not within their budget.
class LiveSolver {
 public:
  // classify: near the solution, for somebody who turns a slider; the thesis' formulations in full.
  //   errors  Error: see sonoskin::classify; Cancelled
  std::shared_ptr<const Volume<float>> classify(const ClassifierInput& input,
                                                const ClassificationOptions& options,
                                                const Progress& progress = {});
  // forget: gives its memory back.
  void forget() { classifier_.reset(); }

 private:
  std::unique_ptr<LiveClassifier> classifier_;
  Key prepared_;
};

}  // namespace sonoskin
