#include "app/cli/streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "core/base/error.h"
#include "core/base/error_text.h"

namespace sonoskin {

void prepareStreams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDWR);  // takes the lowest number that is free
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void writeResult(const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(STDOUT_FILENO, text.data() + done, text.size() - done);
    if (written >= 0) {
      done += std::size_t(written);
      continue;
    }
    if (errno == EINTR) continue;
    if (errno == EPIPE) throw BrokenPipe{};
    throw Error(fmt::format("The result could not be written to standard output: {}.", systemCause(errno)),
                Error::Kind::system);
  }
}

}  // namespace sonoskin
