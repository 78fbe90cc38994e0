#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sonoskin {

// LogLevel: how much a message matters. What stops a task is an Error, not a message.
enum class LogLevel { info, warning };

// LogEntry: one message.
struct LogEntry {
  LogLevel level = LogLevel::info;
  std::string sentence;
};

// log: tells a person something about the task at hand, in one sentence; never what could name a patient, for it goes
// into reports too. The one place that all notes and warnings pass: to the listener, or to standard error where there is
// none, and to every record. What a terminal would obey is taken out of it.
//   threads  any; from the process that reads a file too (core/io/reader_process.h)
void log(LogLevel level, const std::string& sentence);

// logLine: a message as it stands on standard error, with its line end.
std::string logLine(LogLevel level, const std::string& sentence);

// setLogListener: where messages go from now on instead of standard error; an empty one restores that.
// The listener is called on the thread that logs, one call at a time, and must not log itself.
using LogListener = std::function<void(LogLevel level, const std::string& sentence)>;
void setLogListener(LogListener listener);

// LogRecord: all that is logged while it lives, whoever else hears it: for a report, the window's panel, a result.
//   threads  any
class LogRecord {
 public:
  LogRecord();
  ~LogRecord();
  LogRecord(const LogRecord&) = delete;
  LogRecord& operator=(const LogRecord&) = delete;

  // take: what came since the last call, in its order. waiting: whether there is any.
  std::vector<LogEntry> take();
  bool waiting() const;
  // sentences: those of a level that were not taken, each once, in the order of their first coming.
  std::vector<std::string> sentences(LogLevel level) const;

 private:
  friend void log(LogLevel level, const std::string& sentence);
  std::vector<LogEntry> entries_;
};

}  // namespace sonoskin
