#include "core/base/task_pool.h"

#include <immintrin.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/base/thread_priority.h"

namespace sonoskin {
namespace {

// Waits a little for what is about to happen: loops follow each other closely, and to be woken takes longer than this.
template <class Condition>
bool comesSoon(const Condition& condition) {
  constexpr auto kSoon = std::chrono::microseconds(30);
  constexpr int kLooks = 64;  // between two looks at the clock
  const auto end = std::chrono::steady_clock::now() + kSoon;
  do {
    for (int i = 0; i < kLooks; ++i) {
      if (condition()) return true;
      _mm_pause();
    }
  } while (std::chrono::steady_clock::now() < end);
  return false;
}

}  // namespace

TaskPool& TaskPool::instance() {
  static TaskPool* const pool = new TaskPool;
  return *pool;
}

void TaskPool::addThreads(int count) {
  for (; threads_ < count; ++threads_) std::thread([this] { help(); }).detach();
}

void TaskPool::withdraw(Job& job) { offered_ -= int(std::erase(jobs_, &job)); }

void TaskPool::share(const std::function<void()>& work, int helpers) {
  if (helpers <= 0) return work();
  Job job{&work, helpers};
  {
    const std::lock_guard lock(mutex_);
    addThreads(helpers);
    jobs_.push_back(&job);
    ++offered_;
  }
  if (helpers == 1)
    come_.notify_one();
  else
    come_.notify_all();
  work();
  std::unique_lock lock(mutex_);
  withdraw(job);
  lock.unlock();
  const auto haveEnded = [&] { return job.running.load(std::memory_order_acquire) == 0; };
  if (comesSoon(haveEnded)) return;
  lock.lock();
  ended_.wait(lock, haveEnded);
}

void TaskPool::help() {
  if (givesWay_) sonoskin::giveWay();
  std::unique_lock lock(mutex_);
  for (;;) {
    if (jobs_.empty()) {
      lock.unlock();
      comesSoon([&] { return offered_.load(std::memory_order_relaxed) > 0; });
      lock.lock();
    }
    come_.wait(lock, [&] { return waitsForHelp(); });
    Job& job = *jobs_.back();
    ++job.running;
    if (--job.wanted == 0) withdraw(job);
    lock.unlock();
    (*job.work)();
    lock.lock();
    --job.running;
    ended_.notify_all();
  }
}

}  // namespace sonoskin
