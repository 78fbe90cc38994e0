#pragma once

#include <mutex>
#include <string>

#include "core/base/progress.h"
#include "core/base/timer.h"

namespace sonoskin {

// ProgressLine: shows on standard error how far a command is: on a terminal one line that is drawn over and
// over (bar, percent, stage, seconds), elsewhere a plain line for each finished stage, so that logs stay
// short.
//   threads  the sink's cancel may be set anywhere, and say called; all else on the thread that runs the task
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();  // wipes the bar
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  ProgressSink& sink() { return sink_; }
  void beginStage(const std::string& name);
  // finish: wipes the bar, or ends the list of stages; call it when the work went well.
  void finish();
  // say: a line of its own above the bar.
  void say(const std::string& line);

 private:
  void draw(double fraction);
  void wipe();
  void endStage();

  std::mutex mutex_;  // of what is drawn
  ProgressSink sink_;
  bool terminal_;
  Timer total_, stageTimer_, lastDraw_;
  std::string stage_;
  bool drawn_ = false;
};

}  // namespace sonoskin
