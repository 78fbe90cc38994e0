#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/pipeline/pipeline.h"

namespace sonoskin {

// Runner: one background worker that owns a Pipeline. The latest request wins: it cancels the one that runs.
// The window submits, and polls status() and takeResults() once a frame.
class Runner {
 public:
  struct Request {
    Scan scan;
    Parameters parameters;
    Goal goal = Goal::classified;
    bool previewFirst = false;                // deliver a coarse classification before the full one
    std::optional<glm::ivec3> slicesFirst{};  // and before that the slices through this voxel
  };
  struct Status {
    bool busy = false;
    double fraction = 0;         // of the running request
    std::string stage;           // what it is doing, in words
    std::string error;           // sentence of the last failed request; empty after a success or a cancel
    bool cancelled = false;      // the last request was cancelled by cancel()
    std::uint64_t finished = 0;  // number of requests that ended well
  };

  Runner();
  ~Runner();  // cancels and joins
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  void submit(Request request);
  void cancel();
  // forget: cancels, and gives back the memory of all results before anything else is done: another document opens.
  void forget();
  Status status() const;
  // takeResults: the newest results that were not taken yet (a coarse one, then the full one).
  std::optional<Results> takeResults();

 private:
  void cancelAll();
  void work();
  void runRequest(const Request& request);
  void preview(const Request& request, const Progress& progress, const std::function<void(Results)>& deliver);

  Pipeline pipeline_;  // touched by the worker only
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Request> next_;
  std::optional<Results> results_;
  Status status_;
  ProgressSink sink_;
  bool stop_ = false, running_ = false, forgets_ = false;
  std::thread worker_;
};

}  // namespace sonoskin
