// Loops of one thread in the place of core/base/parallel.cpp: inputs are small, teams of threads would cost more than they
// do, and whatever is found repeats itself.
#include "core/base/parallel.h"

namespace sonoskin {

void setThreadCount(int) {}
int threadCount() { return 1; }

void parallelFor(std::ptrdiff_t count, const std::function<void(std::ptrdiff_t)>& body,
                 const Progress& progress) {
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    progress.throwIfCancelled();
    body(i);
  }
}

void parallelThreads(const std::function<void(int, int)>& body) { body(0, 1); }

}  // namespace sonoskin
