#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <vector>

namespace sonoskin {

// TaskPool: threads that help whoever has work to share. They sleep when there is none, so that other programs, and our own
// OpenGL, have the processor; and a loop inside a loop, or beside another thread's, adds no threads of its own.
//   helpers   are made when they are first asked for and live as long as the program
class TaskPool {
 public:
  // the one: never destroyed, since helpers may still sleep in it when the program ends.
  static TaskPool& instance();

  // share: calls work() on this thread and, while that lasts, on up to `helpers` threads that have nothing else to do; returns
  // when every call has. Those who come late find work() with nothing left to do; nobody may have come.
  //   work   may be called several times at once, and may share work itself; throws nothing
  void share(const std::function<void()>& work, int helpers);

  // giveWay: helpers that are made from now on get the processor after the program's other threads: for a program with a
  // window, before any work is shared.
  void giveWay() { givesWay_ = true; }

 private:
  TaskPool() = default;
  // Job: wanted: helpers who may still come; running: those at work.
  struct Job {
    const std::function<void()>* work;
    int wanted = 0;
    std::atomic<int> running{0};
  };
  void addThreads(int count);
  void help();
  bool waitsForHelp() const { return !jobs_.empty(); }
  void withdraw(Job& job);

  std::mutex mutex_;
  std::condition_variable come_, ended_;
  std::vector<Job*> jobs_;       // that want helpers; the last is the innermost
  std::atomic<int> offered_{0};  // jobs in the list, for looks without the mutex
  int threads_ = 0;
  std::atomic<bool> givesWay_{false};
};

}  // namespace sonoskin
