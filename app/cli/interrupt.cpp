#include "app/cli/interrupt.h"

#include <atomic>

namespace sonoskin {
namespace {

std::atomic<std::atomic<bool>*> target{nullptr};
static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler may touch only lock-free atomics");

extern "C" void setCancel(int) {
  if (std::atomic<bool>* cancel = target.load()) cancel->store(true);
}

}  // namespace

Interrupt::Interrupt(ProgressSink& sink) {
  target = &sink.cancel;
  struct sigaction action = {};
  action.sa_handler = setCancel;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &oldInterrupt_);
  sigaction(SIGTERM, &action, &oldTerminate_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &oldInterrupt_, nullptr);
  sigaction(SIGTERM, &oldTerminate_, nullptr);
  target = nullptr;
}

}  // namespace sonoskin
