#include "app/batch/crash_message.h"

#include <unistd.h>

#include <cstring>

namespace sonoskin {
namespace {

const char* volatile message = "";

// Only what a signal handler may call.
extern "C" void writeMessage(int) {
  const char* sentence = message;
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, sentence, std::strlen(sentence));
  ::_exit(1);
}

}  // namespace

CrashMessage::CrashMessage(const char* sentence) {
  message = sentence;
  struct sigaction action = {};
  action.sa_handler = writeMessage;
  ::sigaction(SIGABRT, &action, &oldAbort_);
  ::sigaction(SIGSEGV, &action, &oldAccess_);
}

CrashMessage::~CrashMessage() {
  ::sigaction(SIGABRT, &oldAbort_, nullptr);
  ::sigaction(SIGSEGV, &oldAccess_, nullptr);
}

}  // namespace sonoskin
