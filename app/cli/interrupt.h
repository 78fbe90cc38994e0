#pragma once

#include <semaphore.h>

#include <csignal>
#include <thread>

#include "core/base/progress.h"

namespace sonoskin {

// Interrupt: while it lives, Ctrl+C (SIGINT), SIGTERM and SIGHUP set sink.cancel instead of ending the program. What does not
// look at it within kPatience (a picture being drawn, a library reading a file) is abandoned: unfinished output is
// removed and the program ends as cancelled. One at a time: a signal handler can only reach what is global.
class Interrupt {
 public:
  explicit Interrupt(ProgressSink& sink);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

 private:
  void watch();

  ProgressSink& sink_;
  struct sigaction oldInterrupt_ = {}, oldTerminate_ = {}, oldHangUp_ = {};
  sem_t ended_;
  std::thread watcher_;
};

}  // namespace sonoskin
