#include "core/io/reader_limits.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>

#include "core/io/dicom/dicom_folder.h"
#include "core/io/dicom/dicom_series.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kLeastMemory = 256u << 20, kMostPacked = 1100;
constexpr double kLeastSeconds = 5, kSecondsPerMegabyte = 0.25;

std::uint64_t pageBytes() { return std::uint64_t(::sysconf(_SC_PAGESIZE)); }

// The pages of this process: all that it has asked for, those in memory, and those of them that are a file's.
struct Pages {
  std::uint64_t all = 0, resident = 0, ofFiles = 0;
};

Pages pages() {
  std::ifstream statm("/proc/self/statm");
  Pages p;
  statm >> p.all >> p.resident >> p.ofFiles;
  return p;
}

template <class Iterator>
std::uintmax_t bytesIn(const fs::path& folder) {
  constexpr int kMostFiles = 50'000;
  std::uintmax_t bytes = 0;
  std::error_code code, ignored;
  int files = 0;
  for (Iterator entry(folder, code), end; !code && entry != end && files < kMostFiles;
       entry.increment(code), ++files)
    if (entry->is_regular_file(ignored)) bytes += entry->file_size(ignored);
  return bytes;
}

// Bytes of what a reader of this path may look at: the file, or all files of the folder where a header or a series names
// others, and of the folders in it where a DICOMDIR does.
std::uintmax_t bytesOf(const fs::path& path) {
  const std::string extension = lowerExtension(path);
  const bool isFolder = fs::is_directory(path);
  constexpr std::string_view headers[] = {".mhd", ".nhdr", ".hdr",  ".dat",
                                          ".vvd", ".txt",  ".gltf", ".gz"};  // .hdr.gz too
  if (!isFolder && std::ranges::find(headers, extension) == std::end(headers) && !isDicom(path))
    return fileSize(path);
  const fs::path folder = isFolder ? path : path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!dicomDirectory(path).empty()) return bytesIn<fs::recursive_directory_iterator>(folder);
  return bytesIn<fs::directory_iterator>(folder);
}

}  // namespace

ReaderLimits limitsFor(const fs::path& path) {
  const std::uintmax_t bytes = bytesOf(path), wanted = kLeastMemory + kMostPacked * bytes;
  const std::uintmax_t half = std::uintmax_t(::sysconf(_SC_PHYS_PAGES)) * pageBytes() / 2;
  ReaderLimits limits;
  limits.memory = std::max(kLeastMemory, std::min(wanted, half));
  limits.seconds = kLeastSeconds + kSecondsPerMegabyte * double(bytes) / 1e6;
  limits.allThereIs = half < wanted;
  return limits;
}

void limitTo(const ReaderLimits& limits) {
  const auto set = [](auto what, rlim_t soft, rlim_t hard) {
    const rlimit limit{soft, hard};
    ::setrlimit(what, &limit);
  };
  set(RLIMIT_CORE, 0, 0);
  // At the first a signal comes that tells why, at the second one that cannot be ignored.
  set(RLIMIT_CPU, rlim_t(limits.seconds), rlim_t(limits.seconds) + 2);
// Sanitizers map terabytes of addresses for what they note down, so that any limit of ours would end them.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const rlim_t memory = pages().all * pageBytes() + limits.memory;
  set(RLIMIT_AS, memory, memory);
#endif
}

ReaderEnd endOf(int waitStatus, const rusage& usage, const ReaderLimits& limits,
                std::uint64_t residentBefore) {
  constexpr double kNear = 0.8;
  if (WIFSIGNALED(waitStatus) && WTERMSIG(waitStatus) == SIGXCPU) return ReaderEnd::outOfTime;
  if (WIFSIGNALED(waitStatus) && WTERMSIG(waitStatus) == SIGKILL) return ReaderEnd::killed;
  const double taken = double(usage.ru_maxrss) * 1024 - double(residentBefore);
  return taken > kNear * double(limits.memory) ? ReaderEnd::outOfMemory : ReaderEnd::crashed;
}

// A forked process begins without the pages of files, and takes them as it needs them.
std::uint64_t residentBytes() {
  const Pages p = pages();
  return (p.resident - std::min(p.resident, p.ofFiles)) * pageBytes();
}

Error endError(ReaderEnd end, const fs::path& path, const ReaderLimits& limits) {
  const std::string file = path.string();
  switch (end) {
    case ReaderEnd::outOfTime:
      return Error(
          fmt::format("{} takes more than {:.0f} s to read, which no file of its size needs; get a "
                      "fresh copy, or save it in another format.",
                      file, limits.seconds));
    case ReaderEnd::outOfMemory:
      if (limits.allThereIs)
        return Error(
            fmt::format("{} needs more than half of this machine's memory to read; crop it, or use a "
                        "machine with more.",
                        file));
      return Error(
          fmt::format("{} needs more than {} MB of memory to read, which no file of its size does; "
                      "get a fresh copy, or save it in another format.",
                      file, limits.memory >> 20));
    case ReaderEnd::killed:
      return Error(
          fmt::format("The system ended the process that read {}, as it does where memory is short; close "
                      "other programs and try again.",
                      file),
          Error::Kind::system);
    case ReaderEnd::crashed:
      break;
  }
  return Error(
      fmt::format("{} is damaged or unusual: the library that reads it broke down on it; get a fresh "
                  "copy, or save it in another format.",
                  file));
}

}  // namespace sonoskin
