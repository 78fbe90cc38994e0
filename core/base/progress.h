#pragma once

#include <atomic>
#include <functional>

namespace sonoskin {

// ProgressSink: where a long task reports to and where it looks whether to stop.
//   report   called with a fraction in [0, 1], on the thread that runs the task
//   cancel   set from any thread; the task then throws Cancelled at its next look
struct ProgressSink {
  std::function<void(double fraction)> report;
  std::atomic<bool> cancel{false};
};

// Progress: a slice of a task's progress. Copies are cheap; the default one is silent and is never cancelled.
// Algorithms take it last, call update() at least every 50 ms and hand part() to what they call.
class Progress {
 public:
  Progress() = default;
  explicit Progress(ProgressSink& sink) : sink_(&sink) {}

  // part: the progress of a sub-task that fills [from, to] of this one.
  Progress part(double from, double to) const {
    Progress p = *this;
    p.from_ = from_ + (to_ - from_) * from;
    p.to_ = from_ + (to_ - from_) * to;
    return p;
  }
  // cancelOnly: can be cancelled as this one, but reports nothing; for the inner loops of an iteration.
  Progress cancelOnly() const {
    Progress p = *this;
    p.silent_ = true;
    return p;
  }
  // update: reports `fraction` of this slice; throws Cancelled when asked to stop.
  void update(double fraction) const {
    if (!sink_) return;
    throwIfCancelled();
    if (sink_->report && !silent_) sink_->report(from_ + (to_ - from_) * fraction);
  }
  bool cancelled() const { return sink_ && sink_->cancel.load(std::memory_order_relaxed); }
  void throwIfCancelled() const;  // may be called from any thread

 private:
  ProgressSink* sink_ = nullptr;
  double from_ = 0, to_ = 1;
  bool silent_ = false;
};

}  // namespace sonoskin
