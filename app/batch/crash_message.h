#pragma once

#include <csignal>

namespace sonoskin {

// CrashMessage: while it lives, a library that ends the program by abort or a bad access lets it say one sentence and end
// with status 1. For work whose libraries do so where memory is short; everything that matters must be safe before. One
// at a time: a signal handler can only reach what is global.
class CrashMessage {
 public:
  explicit CrashMessage(const char* sentence);  // a literal, with its line end
  ~CrashMessage();
  CrashMessage(const CrashMessage&) = delete;
  CrashMessage& operator=(const CrashMessage&) = delete;

 private:
  struct sigaction oldAbort_ = {}, oldAccess_ = {};
};

}  // namespace sonoskin
