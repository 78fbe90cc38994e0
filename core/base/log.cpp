#include "core/base/log.h"

#include <fmt/format.h>

#include <cstdio>
#include <mutex>
#include <utility>

namespace sonoskin {
namespace {

struct State {
  std::mutex mutex;
  LogListener listener;
};

State& state() {
  static State s;
  return s;
}

}  // namespace

void log(LogLevel level, const std::string& sentence) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  if (s.listener)
    s.listener(level, sentence);
  else
    std::fputs(
        fmt::format("sonoskin: {}: {}\n", level == LogLevel::warning ? "warning" : "note", sentence).c_str(),
        stderr);
}

void setLogListener(LogListener listener) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  s.listener = std::move(listener);
}

}  // namespace sonoskin
