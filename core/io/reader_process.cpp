#include "core/io/reader_process.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <new>
#include <optional>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/base/timer.h"
#include "core/io/file_bytes.h"
#include "core/io/reader_limits.h"
#include "core/io/reader_task.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr int kMostLogged = 20;  // of what a process led astray may say
// Request: what the server is told, with two descriptors: of the memory for the answer, and of the line for messages.
struct Request {
  ReaderRequest what;
  ReaderLimits limits;
  std::array<char, 4096> path{};
};

// Message: what comes back on the line. `ended` is an Error of the kind `value`, with its text; `logged` has a level,
// `broken` a ReaderEnd.
struct Message {
  enum class What : std::uint8_t { begun, progress, logged, done, ended, broken } what = What::begun;
  double value = 0;  // begun: process; progress: share
  std::array<char, 2000> text{};
};

int server = -1;  // the socket to the process that forks; -1 where there is none
std::mutex serverMutex;

// Descriptor: one that is closed with it.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

// ---- The process that reads one file ----

// Adds a file, or a folder with all in it, to what may be read; false where that fails.
bool allow(int ruleset, const fs::path& path, std::uint64_t access) {
  const Descriptor opened(::open(path.c_str(), O_PATH | O_CLOEXEC));
  landlock_path_beneath_attr beneath{};
  beneath.allowed_access = access;
  beneath.parent_fd = opened.number();
  return opened.number() >= 0 &&
         ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0) == 0;
}

// Only what lies in the folder can be read, and what links there lead to, and nothing written. Kernels without Landlock
// leave it open.
void seeOnly(const fs::path& folder) {
  landlock_ruleset_attr rules{};
  rules.handled_access_fs = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;  // all of the first version
  const Descriptor ruleset(int(::syscall(SYS_landlock_create_ruleset, &rules, sizeof rules, 0)));
  if (ruleset.number() < 0) return;
  constexpr std::uint64_t kFile = LANDLOCK_ACCESS_FS_READ_FILE;
  if (!allow(ruleset.number(), folder, kFile | LANDLOCK_ACCESS_FS_READ_DIR)) return;
  std::error_code code, ignored;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
    if (entry->is_symlink(ignored) && entry->is_regular_file(ignored))
      allow(ruleset.number(), fs::canonical(entry->path(), ignored), kFile);
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
    ::syscall(SYS_landlock_restrict_self, ruleset.number(), 0);
}

void say(int line, Message::What what, double value = 0, const std::string& text = "") {
  Message message;
  message.what = what;
  message.value = value;
  std::strncpy(message.text.data(), text.c_str(), message.text.size() - 1);
  ::send(line, &message, sizeof message, MSG_NOSIGNAL);
}

void writeAll(int file, const void* data, std::size_t bytes) {
  const auto* from = static_cast<const char*>(data);
  for (std::size_t done = 0; done < bytes;) {
    const ssize_t written = ::write(file, from + done, bytes - done);
    if (written <= 0) throw std::bad_alloc();
    done += std::size_t(written);
  }
}

[[noreturn]] void work(const Request& request, int answer, int line) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  say(line, Message::What::begun, double(::getpid()));
  const fs::path path(request.path.data());
  std::error_code code;
  const bool isFolder = fs::is_directory(path, code);
  const fs::path folder = isFolder ? path : path.has_parent_path() ? path.parent_path() : fs::path(".");
  limitTo(request.limits);
  seeOnly(folder);
  ProgressSink sink;
  sink.report = [&](double share) { say(line, Message::What::progress, share); };
  setLogListener([&](LogLevel level, const std::string& sentence) {
    say(line, Message::What::logged, double(level), sentence);
  });
  try {
    performTask(
        request.what, path, [&](const void* data, std::size_t bytes) { writeAll(answer, data, bytes); },
        Progress(sink));
    say(line, Message::What::done);
  } catch (const Error& error) {
    say(line, Message::What::ended, double(error.kind()), error.what());
  } catch (const std::bad_alloc&) {
    say(line, Message::What::broken, double(ReaderEnd::outOfMemory));
  } catch (...) {
  }  // the end without a word says enough
  ::_exit(0);
}

// Waits for the process that reads, and says how it ended; after its own last word nobody listens any more.
[[noreturn]] void attend(const Request& request, int answer, int line) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGCHLD, SIG_DFL);
  const std::uint64_t before = residentBytes();
  const pid_t reader = ::fork();
  if (reader == 0) work(request, answer, line);
  ::close(answer);
  rusage usage{};
  int status = 0;
  while (::wait4(reader, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  const ReaderEnd end = reader < 0 ? ReaderEnd::killed : endOf(status, usage, request.limits, before);
  say(line, Message::What::broken, double(end));
  ::_exit(0);
}

// ---- The process that waits ----

// Receives a request with its two descriptors; nothing when the program has ended.
std::optional<std::array<int, 2>> receive(int socket, Request& request) {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(2 * sizeof(int))> space{};
  iovec data{&request, sizeof request};
  msghdr message{};
  message.msg_iov = &data, message.msg_iovlen = 1;
  message.msg_control = space.data(), message.msg_controllen = space.size();
  ssize_t got;
  while ((got = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {
  }
  const cmsghdr* header = CMSG_FIRSTHDR(&message);
  if (got != ssize_t(sizeof request) || !header || header->cmsg_len != CMSG_LEN(2 * sizeof(int))) return {};
  std::array<int, 2> descriptors;
  std::memcpy(descriptors.data(), CMSG_DATA(header), sizeof descriptors);
  return descriptors;
}

[[noreturn]] void serve(int socket) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::setpgid(0, 0);  // Ctrl+C in a terminal is the program's to answer
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (int stream = 0; stream <= 2; ++stream) ::dup2(nowhere, stream);  // libraries quote files
  std::signal(SIGCHLD, SIG_IGN);
  Request request;
  while (const auto descriptors = receive(socket, request)) {
    if (::fork() == 0) {
      ::close(socket);
      attend(request, (*descriptors)[0], (*descriptors)[1]);
    }
    for (const int descriptor : *descriptors) ::close(descriptor);
  }
  ::_exit(0);
}

// ---- The program ----

bool sendRequest(const Request& request, std::array<int, 2> descriptors) {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(2 * sizeof(int))> space{};
  Request copy = request;
  iovec data{&copy, sizeof copy};
  msghdr message{};
  message.msg_iov = &data, message.msg_iovlen = 1;
  message.msg_control = space.data(), message.msg_controllen = space.size();
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET, header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(2 * sizeof(int));
  std::memcpy(CMSG_DATA(header), descriptors.data(), sizeof descriptors);
  const std::lock_guard lock(serverMutex);
  return ::sendmsg(server, &message, MSG_NOSIGNAL) == ssize_t(sizeof copy);
}

// Reader: the process that reads for this program; it ends with it.
class Reader {
 public:
  Reader(const ReaderRequest& what, const fs::path& path)
      : path_(path),
        limits_(limitsFor(path)),
        answer_(::memfd_create("sonoskin", MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
    std::array<int, 2> line{-1, -1};
    Request request{what, limits_, {}};
    const std::string name = path.string();
    require(name.size() < request.path.size(), "{} is too long a name; give the file a shorter one.",
            name.substr(0, 80) + "...");
    std::memcpy(request.path.data(), name.data(), name.size());
    if (answer_.number() < 0 || ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, line.data()) != 0)
      throw Error("No file can be read: the system gives no memory or sockets; close other programs.",
                  Error::Kind::system);
    line_ = line[0];
    const Descriptor theirs(line[1]);
    if (!sendRequest(request, {answer_.number(), line[1]}))
      throw Error("No file can be read any more; start the program again.", Error::Kind::system);
  }
  ~Reader() {
    if (process_ > 0) ::kill(process_, SIGKILL);
    if (line_ >= 0) ::close(line_);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  // Until the answer is complete.
  void wait(const Progress& progress) {
    constexpr int kLookEvery = 20;  // ms
    const Timer timer;
    for (;;) {
      progress.throwIfCancelled();
      pollfd ready{line_, POLLIN, 0};
      if (::poll(&ready, 1, kLookEvery) > 0 && take(progress)) return;
      if (timer.seconds() > 2 * limits_.seconds) throw endError(ReaderEnd::outOfTime, path_, limits_);
    }
  }

  ReaderAnswer answer() const { return ReaderAnswer(answer_.number()); }

 private:
  // One message; whether it was the last one.
  bool take(const Progress& progress) {
    Message message;
    const ssize_t got = ::recv(line_, &message, sizeof message, 0);
    if (got < 0 && errno == EINTR) return false;
    if (got != ssize_t(sizeof message)) {
      process_ = 0;
      throw endError(ReaderEnd::killed, path_, limits_);  // the one that attends has gone too
    }
    message.text.back() = 0;
    switch (message.what) {
      case Message::What::begun:
        process_ = pid_t(message.value);
        return false;
      case Message::What::progress:
        progress.update(std::clamp(message.value, 0.0, 1.0));
        return false;
      case Message::What::logged:
        if (++logged_ <= kMostLogged)
          log(message.value == double(LogLevel::warning) ? LogLevel::warning : LogLevel::info,
              message.text.data());
        return false;
      case Message::What::ended:
        process_ = 0;
        throw Error(message.text.data(), Error::Kind(std::clamp(int(message.value), 0, 2)));
      case Message::What::broken:
        process_ = 0;
        throw endError(ReaderEnd(std::clamp(int(message.value), 0, int(ReaderEnd::killed))), path_, limits_);
      case Message::What::done:
        break;
    }
    process_ = 0;
    return true;
  }

  fs::path path_;
  ReaderLimits limits_;
  Descriptor answer_;
  int line_ = -1;
  pid_t process_ = 0;
  int logged_ = 0;
};

}  // namespace

void startReaders() {
  std::array<int, 2> ends;
  if (server >= 0 || ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
  const pid_t waiting = ::fork();
  if (waiting == 0) {
    ::close(ends[0]);
    serve(ends[1]);
  }
  ::close(ends[1]);
  if (waiting > 0)
    server = ends[0];
  else
    ::close(ends[0]);
}

bool readersRun() { return server >= 0; }

// Sealed, so that nothing can be taken away from under the reader.
ReaderAnswer::ReaderAnswer(int memory) {
  struct stat facts;
  if (::fcntl(memory, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW) != 0 || ::fstat(memory, &facts) != 0 ||
      facts.st_size <= 0)
    return;
  void* mapped = ::mmap(nullptr, std::size_t(facts.st_size), PROT_READ, MAP_SHARED, memory, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  data_ = static_cast<const std::uint8_t*>(mapped);
  size_ = std::size_t(facts.st_size);
}

ReaderAnswer::~ReaderAnswer() {
  if (data_) ::munmap(const_cast<std::uint8_t*>(data_), size_);
}

ReaderAnswer readApart(const ReaderRequest& request, const fs::path& path, const Progress& progress) {
  std::error_code code;
  if (!fs::is_directory(path, code)) fileSize(path);  // says what is no ordinary file, without opening it
  Reader reader(request, path);
  reader.wait(progress);
  return reader.answer();
}

}  // namespace sonoskin
