#pragma once

#include <functional>
#include <string>

namespace sonoskin {

// LogLevel: how much a message matters. What stops a task is an Error, not a message.
enum class LogLevel { info, warning };

// log: tells a person something about the task at hand, in one sentence; never what could name a patient.
// Goes to the listener, or to standard error where there is none. May be called from any thread.
void log(LogLevel level, const std::string& sentence);

// setLogListener: where messages go from now on (the window's log panel, a test); an empty one restores standard error.
// The listener is called on the thread that logs, one call at a time, and must not log itself.
using LogListener = std::function<void(LogLevel level, const std::string& sentence)>;
void setLogListener(LogListener listener);

}  // namespace sonoskin
