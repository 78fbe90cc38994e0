#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/base/progress.h"
#include "core/io/read_options.h"

// A process of its own for the libraries that parse files of strangers. They end in asserts, stack overflows and
// requests for gigabytes, which no `catch` helps against; so whatever a file does there costs that process alone.
namespace sonoskin {

// ReaderTask: what is read. The answer is what reader_wire.h makes of it.
enum class ReaderTask : std::uint8_t { volume, list, mesh };

// ReaderAnswer: bytes in memory that was shared with the process that made them; it has ended.
class ReaderAnswer {
 public:
  explicit ReaderAnswer(int memory);  // a descriptor, which stays the caller's
  ~ReaderAnswer();
  ReaderAnswer(const ReaderAnswer&) = delete;
  ReaderAnswer& operator=(const ReaderAnswer&) = delete;
  std::span<const std::uint8_t> bytes() const { return {data_, size_}; }

 private:
  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

// startReaders: from now on files are read apart. Call once, before the program has threads: a small process is forked
// that waits, and forks again for every file. It ends with the program.
//   cost   1 ms, and 1 ms for each file
void startReaders();
// readersRun: whether they were started; without them callers read by themselves.
bool readersRun();

// ReaderRequest: what is read, and what of it.
struct ReaderRequest {
  ReaderTask task = ReaderTask::volume;
  ReadOptions options{};
};

// readApart: reads a file, or a folder with a DICOM series, in a process that has
//   memory, time  for a file of its size: reader_limits.h
//   files   read-only, those in the folder of what is read and those that links there lead to, where the kernel has Landlock (Linux 5.13); no new ones
//   errors  Error: that of the reader; or the process broke down, took too long, too much memory, or was killed, told
//           apart; not an ordinary file.
//           Cancelled: the process is killed
//   threads any, several at once
ReaderAnswer readApart(const ReaderRequest& request, const std::filesystem::path& path,
                       const Progress& progress = {});

}  // namespace sonoskin
