#pragma once

#include <sys/resource.h>

#include <cstdint>
#include <filesystem>

#include "core/base/error.h"

namespace sonoskin {

// ReaderLimits: what a process that reads one file may use.
//   seconds   of the processor; by the clock twice that
//   allThereIs  whether the memory is bounded by the machine's, not by the file's size
struct ReaderLimits {
  std::uint64_t memory = 0;  // bytes beyond those of the program
  double seconds = 0;
  bool allThereIs = false;
};

// limitsFor: for a file, or for a folder with a DICOM series:
//   memory  256 MB, and 1100 times the size at most (what zlib can unpack), of half of the machine's
//   time    5 s, and a quarter of a second for every megabyte
//   errors  Error: no such file
ReaderLimits limitsFor(const std::filesystem::path& path);

// limitTo: sets them for this process, for good.
void limitTo(const ReaderLimits& limits);

// ReaderEnd: how such a process ended without an answer.
//   killed   by the system, which does so where memory is short, or by a person
enum class ReaderEnd { crashed, outOfMemory, outOfTime, killed };

// endOf: from what wait4 says of a process under these limits. A crash near its limit of memory is for want of it.
//   input  residentBefore  bytes in memory before it began to read
ReaderEnd endOf(int waitStatus, const rusage& usage, const ReaderLimits& limits,
                std::uint64_t residentBefore);

// residentBytes: of this process, in memory now, that one forked from it has from its beginning.
std::uint64_t residentBytes();

// endError: the sentence for it.
Error endError(ReaderEnd end, const std::filesystem::path& path, const ReaderLimits& limits);

}  // namespace sonoskin
