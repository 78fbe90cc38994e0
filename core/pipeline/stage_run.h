#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/timer.h"
#include "core/pipeline/result_bytes.h"
#include "core/pipeline/result_memory.h"
#include "core/pipeline/results.h"
#include "core/pipeline/stage_shares.h"
#include "core/volume/scan.h"

namespace sonoskin {

// Keyed: a stage's result, and the fingerprint of all that it was made from. What is made of it takes its key from that.
template <class T>
struct Keyed {
  std::shared_ptr<const T> value;
  Key key;
};

// StageRun: one run of the pipeline: looks whether a stage's result is remembered, else has it made, hands it its slice of the
// progress and notes what it cost.
class StageRun {
 public:
  using StageBegins = std::function<void(const std::string& name)>;
  //   reports  what the stages cost; outlives this
  StageRun(ResultMemory& memory, const Progress& progress, StageBegins stageBegins,
           std::vector<StageReport>& reports)
      : memory_(memory), progress_(progress), stageBegins_(std::move(stageBegins)), reports_(reports) {}

  template <class T>
  bool knows(const Key& key) {
    return memory_.find<T>(key) != nullptr;
  }

  // stage: the remembered result for `key`, or a new one; the progress then stands at the end of the stage's share.
  //   compute  takes its progress; gives a T, or a std::shared_ptr to one
  //   errors   Cancelled, and those of `compute`; nothing is remembered then
  template <class T, class Compute>
  Keyed<T> stage(const StageShare& share, const Key& key, const Compute& compute) {
    const Progress part = progress_.part(std::exchange(at_, share.until), share.until);
    progress_.throwIfCancelled();
    if (auto known = memory_.find<T>(key)) {
      reports_.push_back({share.name, 0, 0});
      return {std::move(known), key};
    }
    if (stageBegins_) stageBegins_(share.name);
    const Timer timer;
    std::shared_ptr<const T> made = shared<T>(compute(part));
    const std::size_t bytes = bytesOf(*made);
    memory_.remember(key, made, bytes);
    reports_.push_back({share.name, timer.seconds(), bytes});
    return {std::move(made), key};
  }

 private:
  template <class T>
  static std::shared_ptr<const T> shared(T made) {
    return std::make_shared<const T>(std::move(made));
  }
  template <class T>
  static std::shared_ptr<const T> shared(std::shared_ptr<const T> made) {
    return made;
  }

  ResultMemory& memory_;
  Progress progress_;
  StageBegins stageBegins_;
  std::vector<StageReport>& reports_;
  double at_ = 0;
};

// StageContext: what all stages of one run share.
struct StageContext {
  const Scan& scan;
  const Parameters& parameters;
  const StageShares& shares;
  StageRun& run;
};

}  // namespace sonoskin
