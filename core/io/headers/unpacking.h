#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "core/io/headers/declared_data.h"

namespace sonoskin {

// isPacked: whether a file begins as gzip does.
//   errors  as fileSize
bool isPacked(const std::filesystem::path& path);

// unpackedStart: the first `bytes` of a file, unpacked where it is packed; fewer where it ends early.
//   errors  as fileSize; Error: it cannot be read
std::vector<std::uint8_t> unpackedStart(const std::filesystem::path& path, std::size_t bytes);

// Sink: takes the next of some bytes.
using Sink = std::function<void(std::span<const std::uint8_t>)>;

// unpack: gives all that is packed in a part of a file, piece by piece, to the end of the stream, whose
// checksum is compared.
//   input   encoding  packed or bzip2
//           bytes     how many are to come at least; no more than a little above that are looked at
//   errors  Error: it is damaged, ends before so many bytes, or holds more
//   cost    300 MB of output a second; a quarter of a megabyte of memory
void unpack(const DataPart& part, Encoding encoding, std::uintmax_t bytes, const Sink& sink);

}  // namespace sonoskin
