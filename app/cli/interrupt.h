#pragma once

#include <csignal>

#include "core/base/progress.h"

namespace sonoskin {

// Interrupt: while it lives, Ctrl+C (SIGINT) and SIGTERM set sink.cancel instead of ending the program. One
// at a time: a signal handler can only reach what is global.
class Interrupt {
 public:
  explicit Interrupt(ProgressSink& sink);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

 private:
  struct sigaction oldInterrupt_ = {}, oldTerminate_ = {};
};

}  // namespace sonoskin
