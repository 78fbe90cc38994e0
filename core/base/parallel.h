#pragma once

#include <cstddef>
#include <functional>

#include "core/base/progress.h"

namespace sonoskin {

// The number of threads that parallel loops use, on whichever thread they start. 0 restores the machine's
// own.
void setThreadCount(int count);
int threadCount();

// parallelFor: calls body(i) once for every i in [0, count), on threadCount() threads.
//   order    any; results must not depend on it (reduce over per-i partial sums, in order, afterwards)
//   errors   the first exception thrown by a body; Cancelled, looked at before every i
// Choose i coarse (a slice, a block): one call should cost 10 us or more and 50 ms at most.
void parallelFor(std::ptrdiff_t count, const std::function<void(std::ptrdiff_t)>& body,
                 const Progress& progress = {});

// parallelThreads: calls body(thread, threads) once for each of threadCount() threads, or one after the other where threads
// are busy elsewhere; for loops that keep scratch memory per thread or own a fixed slab of the data.
void parallelThreads(const std::function<void(int thread, int threads)>& body);

}  // namespace sonoskin
