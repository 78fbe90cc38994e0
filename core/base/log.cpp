#include "core/base/log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <utility>

namespace sonoskin {
namespace {

constexpr std::size_t kMostKept = 1000;  // entries of a record that nobody takes

struct State {
  std::mutex mutex;
  LogListener listener;
  std::vector<LogRecord*> records;
};

State& state() {
  static State s;
  return s;
}

std::string withoutControls(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

}  // namespace

std::string logLine(LogLevel level, const std::string& sentence) {
  return fmt::format("sonoskin: {}: {}\n", level == LogLevel::warning ? "warning" : "note", sentence);
}

void log(LogLevel level, const std::string& given) {
  const std::string sentence = withoutControls(given);
  State& s = state();
  const std::lock_guard lock(s.mutex);
  for (LogRecord* record : s.records)
    if (record->entries_.size() < kMostKept) record->entries_.push_back({level, sentence});
  if (s.listener)
    s.listener(level, sentence);
  else
    std::fputs(logLine(level, sentence).c_str(), stderr);
}

void setLogListener(LogListener listener) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  s.listener = std::move(listener);
}

LogRecord::LogRecord() {
  const std::lock_guard lock(state().mutex);
  state().records.push_back(this);
}

LogRecord::~LogRecord() {
  const std::lock_guard lock(state().mutex);
  std::erase(state().records, this);
}

std::vector<LogEntry> LogRecord::take() {
  const std::lock_guard lock(state().mutex);
  return std::exchange(entries_, {});
}

bool LogRecord::waiting() const {
  const std::lock_guard lock(state().mutex);
  return !entries_.empty();
}

std::vector<std::string> LogRecord::sentences(LogLevel level) const {
  const std::lock_guard lock(state().mutex);
  std::vector<std::string> found;
  for (const LogEntry& entry : entries_)
    if (entry.level == level && std::ranges::count(found, entry.sentence) == 0)
      found.push_back(entry.sentence);
  return found;
}

}  // namespace sonoskin
