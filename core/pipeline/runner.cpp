#include "core/pipeline/runner.h"

#include <utility>

#include "core/base/error.h"
#include "core/base/error_text.h"
#include "core/base/free_memory.h"
#include "core/base/thread_priority.h"

namespace sonoskin {
namespace {

// Voxels beyond which the full answer takes so long, half a second, that one on larger voxels is worth its time.
constexpr std::size_t kSlowVolume = 30'000'000;
// Voxels up to which the full answer is there in a twentieth of a second.
constexpr std::size_t kQuickVolume = 3'000'000;

}  // namespace

Runner::Runner() {
  sink_.report = [this](double fraction) {
    const std::lock_guard lock(mutex_);
    status_.fraction = fraction;
  };
  worker_ = std::thread([this] { work(); });
}

Runner::~Runner() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    sink_.cancel = true;
  }
  wake_.notify_one();
  worker_.join();
}

void Runner::submit(Request request) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(request);
    results_.reset();  // of an earlier request, perhaps of another scan
    status_.busy = true;
    status_.error.clear();
    status_.cancelled = false;
    sink_.cancel = true;  // whatever runs now is out of date
  }
  wake_.notify_one();
}

// The lock is held.
void Runner::cancelAll() {
  if (!status_.busy) return;
  next_.reset();
  status_.busy = running_;
  status_.cancelled = true;
  sink_.cancel = true;
}

void Runner::cancel() {
  const std::lock_guard lock(mutex_);
  cancelAll();
}

void Runner::forget() {
  {
    const std::lock_guard lock(mutex_);
    cancelAll();
    results_.reset();
    forgets_ = true;
  }
  wake_.notify_one();
}

Runner::Status Runner::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::optional<Results> Runner::takeResults() {
  const std::lock_guard lock(mutex_);
  return std::exchange(results_, std::nullopt);
}

void Runner::work() {
  giveWay();
  bool others = false;  // memory of another document may be free
  for (;;) {
    std::optional<Request> request;
    bool forgets = false;
    {
      std::unique_lock lock(mutex_);
      running_ = false;
      status_.busy = next_.has_value();
      wake_.wait(lock, [this] { return stop_ || next_ || forgets_; });
      if (stop_) return;
      forgets = std::exchange(forgets_, false);
      request = std::exchange(next_, std::nullopt);
      sink_.cancel = false;
      running_ = status_.busy = request.has_value();
      status_.fraction = 0;
    }
    if (forgets) pipeline_.forget();
    others |= forgets;
    if (!request) continue;
    runRequest(*request);
    if (request->goal == Goal::mesh || (others && request->goal == Goal::points)) {
      returnFreeMemory();
      others = false;
    }
  }
}

// What is looked at comes first. Results that were not taken yet make room for later ones: these hold them too.
void Runner::preview(const Request& request, const Progress& progress,
                     const std::function<void(Results)>& deliver) {
  const Scan& scan = request.scan;
  Results first;
  if (request.slicesFirst && scan.volume->data.size() > kQuickVolume) {
    first = pipeline_.slices(scan, request.parameters, *request.slicesFirst, progress.part(0, 0.02), deliver);
  }
  const auto coarse = [&](Preview level, const Progress& part) {
    Results results = pipeline_.preview(scan, request.parameters, level, part);
    results.slices = first.slices;
    deliver(std::move(results));
  };
  coarse(Preview::quarter, progress.part(0.02, 0.05));
  if (scan.volume->data.size() > kSlowVolume) coarse(Preview::half, progress.part(0.05, 0.1));
}

void Runner::runRequest(const Request& request) {
  const auto deliver = [this](Results results) {
    const std::lock_guard lock(mutex_);
    if (!sink_.cancel) results_ = std::move(results);  // else it ended before it saw that nobody wants it
  };
  const auto fail = [this](const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    if (!sink_.cancel) status_.error = sentence;
  };
  const auto stageBegins = [this](const std::string& name) {
    const std::lock_guard lock(mutex_);
    status_.stage = name;
  };
  try {
    const Progress progress(sink_);
    if (request.previewFirst) {
      stageBegins("preview");
      preview(request, progress, deliver);
    }
    deliver(pipeline_.run(request.scan, request.parameters, request.goal,
                          progress.part(request.previewFirst ? 0.1 : 0, 1), stageBegins));
    const std::lock_guard lock(mutex_);
    ++status_.finished;
    status_.fraction = 1;
  } catch (const Cancelled&) {
    // Either a newer request waits, or the person asked to stop: nothing to say.
  } catch (const std::exception& error) {
    fail(errorText(error));
  }
}

}  // namespace sonoskin
