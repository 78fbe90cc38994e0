#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

#include "core/base/processors.h"
#include "core/base/task_pool.h"

namespace sonoskin {
namespace {

std::atomic<int> requestedThreads{0};

// The first exception of several threads, to be thrown again on the one that called them.
class FirstException {
 public:
  void capture() {
    if (!taken_.exchange(true)) exception_ = std::current_exception();
  }
  bool taken() const { return taken_.load(std::memory_order_relaxed); }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::atomic<bool> taken_{false};
  std::exception_ptr exception_;
};

}  // namespace

void setThreadCount(int count) { requestedThreads = count > 0 ? count : 0; }

int threadCount() {
  static const int available = availableProcessors();
  const int requested = requestedThreads;
  return requested > 0 ? requested : available;
}

void parallelFor(std::ptrdiff_t count, const std::function<void(std::ptrdiff_t)>& body,
                 const Progress& progress) {
  FirstException first;
  std::atomic<std::ptrdiff_t> next{0}, done{0};
  const auto caller = std::this_thread::get_id();
  const std::function<void()> work = [&] {
    const bool reports = std::this_thread::get_id() == caller;
    for (std::ptrdiff_t i = next++; i < count && !first.taken(); i = next++) try {
        progress.throwIfCancelled();
        body(i);
        const std::ptrdiff_t finished = done.fetch_add(1, std::memory_order_relaxed) + 1;
        if (reports && finished < count) progress.update(double(finished) / double(count));
      } catch (...) {
        first.capture();
      }
  };
  TaskPool::instance().share(work, int(std::min<std::ptrdiff_t>(threadCount(), count)) - 1);
  first.rethrow();
  // Only this thread reports, and on a busy machine the others may have done all the work.
  if (count > 0) progress.update(1);
}

void parallelThreads(const std::function<void(int, int)>& body) {
  const int threads = threadCount();
  parallelFor(threads, [&](std::ptrdiff_t thread) { body(int(thread), threads); });
}

}  // namespace sonoskin
