#pragma once

#include <csignal>

namespace sonoskin {

// LastWords: while it lives, a library that ends the program by abort or a bad access lets it say one sentence and end
// with status 1. For work whose libraries do so where memory is short; everything that matters must be safe before. One
// at a time: a signal handler can only reach what is global.
class LastWords {
 public:
  explicit LastWords(const char* sentence);  // a literal, with its line end
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

 private:
  struct sigaction oldAbort_ = {}, oldAccess_ = {};
};

}  // namespace sonoskin
