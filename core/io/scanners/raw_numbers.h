#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/io/raw_options.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// RawNumbers: where the numbers of a volume lie in a file that holds nothing else, and how.
//   frame    numbers of one time step, 1 or more
//   header   bytes before the first of them; -1: all that is more than the numbers
//   step     which of `timeSteps` volumes one after another, counted from 1
struct RawNumbers {
  std::filesystem::path file;
  NumberType type = NumberType::uint8;
  ByteOrder byteOrder = ByteOrder::little;
  std::uint64_t frame = 1;
  std::int64_t header = 0;
  int timeSteps = 1, step = 1;
};

// countNumbers: of a volume of these dimensions.
//   errors  Error: below 2 or above 65535 along an axis, or more than 2^31 in all
std::uint64_t countNumbers(const glm::ivec3& dims, int components, const std::filesystem::path& path);

// readNumbers: those of one time step, in this machine's byte order.
//   path     the file that a person named, for sentences
//   errors   Error: the file does not hold so many, or cannot be read. Says by the log where it holds more.
std::vector<std::uint8_t> readNumbers(const RawNumbers& numbers, const std::filesystem::path& path);

}  // namespace sonoskin
