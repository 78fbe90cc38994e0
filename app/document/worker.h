#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/base/progress.h"

namespace sonoskin {

// Worker: one background thread for the window's own long tasks (opening, simulating, saving), so that no
// frame waits for a disk. Reconstruction has a worker of its own, the pipeline's Runner.
class Worker {
 public:
  // Task: `work` runs in the background; then `done` runs inside poll(), unless the work failed or was
  // cancelled.
  struct Task {
    std::string label;  // what it does, for people: "Opening face.nrrd"
    std::function<void(const Progress&)> work;
    std::function<void()> done;
  };
  struct Status {
    bool busy = false;
    double fraction = 0;
    std::string label;
  };

  Worker();
  ~Worker();  // cancels and joins

  void append(Task task);   // after those that wait
  void replace(Task task);  // instead of them; the running one is cancelled
  void cancel();            // all of them
  Status status() const;
  // poll: runs `done` of every task that ended well; returns the sentences of those that failed, then or before.
  //   threads  the one that owns what `done` touches
  std::vector<std::string> poll();

 private:
  void work();
  void runTask(Task task, std::unique_lock<std::mutex>& lock);
  void dropAll();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Task> waiting_;
  std::vector<std::function<void()>> done_;
  std::vector<std::string> failed_;
  Status status_;
  ProgressSink sink_;
  bool stop_ = false, running_ = false;
  std::thread thread_;
};

}  // namespace sonoskin
