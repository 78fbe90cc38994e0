#include "app/cli/interrupt.h"

#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "app/cli/exit_status.h"
#include "core/io/atomic_file.h"

namespace sonoskin {
namespace {

constexpr long kPatience = 200'000'000;  // ns

// What the signal handler reaches. sem_post is one of the few calls that a handler may make.
std::atomic<std::atomic<bool>*> target{nullptr};
sem_t asked;
static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler may touch only lock-free atomics");

extern "C" void setCancel(int) {
  if (std::atomic<bool>* cancel = target.load()) {
    cancel->store(true);
    sem_post(&asked);
  }
}

void wait(sem_t& semaphore) {
  while (sem_wait(&semaphore) != 0) {
  }  // interrupted by a signal: go on waiting
}

// waitFor: whether the semaphore was posted within so many nanoseconds.
bool waitFor(sem_t& semaphore, long nanoseconds) {
  timespec until;
  clock_gettime(CLOCK_REALTIME, &until);
  until.tv_nsec += nanoseconds;
  until.tv_sec += until.tv_nsec / 1'000'000'000;
  until.tv_nsec %= 1'000'000'000;
  int failed;
  while ((failed = sem_timedwait(&semaphore, &until)) != 0 && errno == EINTR) {
  }
  return failed == 0;
}

}  // namespace

Interrupt::Interrupt(ProgressSink& sink) : sink_(sink) {
  sem_init(&asked, 0, 0);
  sem_init(&ended_, 0, 0);
  target = &sink.cancel;
  watcher_ = std::thread([this] { watch(); });
  struct sigaction action = {};
  action.sa_handler = setCancel;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, &oldInterrupt_);
  sigaction(SIGTERM, &action, &oldTerminate_);
  sigaction(SIGHUP, &action, &oldHangUp_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &oldInterrupt_, nullptr);
  sigaction(SIGTERM, &oldTerminate_, nullptr);
  sigaction(SIGHUP, &oldHangUp_, nullptr);
  target = nullptr;
  sem_post(&ended_);
  sem_post(&asked);  // wakes the watcher where no signal came
  watcher_.join();
  sem_destroy(&asked);
  sem_destroy(&ended_);
}

void Interrupt::watch() {
  wait(asked);
  if (!sink_.cancel || waitFor(ended_, kPatience)) return;
  std::fputs(
      fmt::format("{}sonoskin: error: {}\n", isatty(STDERR_FILENO) ? "\r\033[K" : "", cancelledSentence())
          .c_str(),
      stderr);
  abandonOutput(kCancelled);
}

}  // namespace sonoskin
