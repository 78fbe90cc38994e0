#include "app/document/worker.h"

#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/base/error_text.h"
#include "core/base/thread_priority.h"

namespace sonoskin {

Worker::Worker() {
  sink_.report = [this](double fraction) {
    const std::lock_guard lock(mutex_);
    status_.fraction = fraction;
  };
  thread_ = std::thread([this] { work(); });
}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    dropAll();
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

// The lock is held. A running task ends at its next look at its progress; nothing of it is delivered.
void Worker::dropAll() {
  waiting_.clear();
  done_.clear();
  sink_.cancel = true;
}

void Worker::append(Task task) {
  {
    const std::lock_guard lock(mutex_);
    if (!status_.busy) status_ = {true, 0, task.label};
    waiting_.push_back(std::move(task));
  }
  wake_.notify_all();
}

void Worker::replace(Task task) {
  {
    const std::lock_guard lock(mutex_);
    dropAll();
    status_ = {true, 0, task.label};
    waiting_.push_back(std::move(task));
  }
  wake_.notify_all();
}

void Worker::cancel() {
  const std::lock_guard lock(mutex_);
  dropAll();
  if (!running_) status_ = {};  // the thread had not begun, and has nothing to wake for
}

Worker::Status Worker::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::vector<std::string> Worker::poll() {
  std::vector<std::function<void()>> done;
  std::vector<std::string> failed;
  {
    const std::lock_guard lock(mutex_);
    std::swap(done, done_);
    std::swap(failed, failed_);
  }
  for (const auto& action : done) {
    try {
      action();
    } catch (const std::exception& error) {
      failed.push_back(errorText(error));  // the others' turn comes all the same
    }
  }
  return failed;
}

void Worker::work() {
  giveWay();
  std::unique_lock lock(mutex_);
  while (true) {
    if (waiting_.empty()) status_ = {};
    wake_.wait(lock, [this] { return stop_ || !waiting_.empty(); });
    if (stop_) return;
    Task task = std::move(waiting_.front());
    waiting_.pop_front();
    runTask(std::move(task), lock);
  }
}

void Worker::runTask(Task task, std::unique_lock<std::mutex>& lock) {
  status_ = {true, 0, task.label};
  sink_.cancel = false;
  running_ = true;
  lock.unlock();
  std::string failure;
  bool ended = false;
  try {
    task.work(Progress(sink_));
    ended = true;
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    failure = errorText(error);
  }
  lock.lock();
  running_ = false;
  if (sink_.cancel) return;  // dropped meanwhile: nobody waits for it any more
  if (ended && task.done) done_.push_back(std::move(task.done));
  if (!failure.empty()) failed_.push_back(failure);
}

}  // namespace sonoskin
