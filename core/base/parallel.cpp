#include "core/base/parallel.h"

#include <omp.h>

#include <atomic>
#include <exception>

namespace sonoskin {
namespace {

std::atomic<int> requestedThreads{0};

// The first exception of a team of threads, to be thrown again outside the parallel region.
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
  const int requested = requestedThreads;
  return requested > 0 ? requested : omp_get_num_procs();
}

void parallelFor(std::ptrdiff_t count, const std::function<void(std::ptrdiff_t)>& body,
                 const Progress& progress) {
  FirstException first;
  std::atomic<std::ptrdiff_t> done{0};
#pragma omp parallel for schedule(dynamic, 1) num_threads(threadCount())
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    if (first.taken()) continue;
    try {
      progress.throwIfCancelled();
      body(i);
      const std::ptrdiff_t finished = done.fetch_add(1, std::memory_order_relaxed) + 1;
      if (omp_get_thread_num() == 0 && finished < count) progress.update(double(finished) / double(count));
    } catch (...) {
      first.capture();
    }
  }
  first.rethrow();
  // Only this thread reports, and on a busy machine the others may have done all the work.
  if (count > 0) progress.update(1);
}

void parallelThreads(const std::function<void(int, int)>& body) {
  FirstException first;
#pragma omp parallel num_threads(threadCount())
  {
    try {
      body(omp_get_thread_num(), omp_get_num_threads());
    } catch (...) {
      first.capture();
    }
  }
  first.rethrow();
}

}  // namespace sonoskin
