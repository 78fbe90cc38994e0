#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>

#include "core/io/headers/unpacking.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// readTextNumbers: numbers that are written as words between blanks, as bytes of their type in this machine's
// order.
//   errors  Error: there are fewer; a word is no number, or none that the type holds
void readTextNumbers(std::istream& text, NumberType type, std::uint64_t count,
                     const std::filesystem::path& path, const Sink& sink);

// readHexBytes: bytes that are written as two hexadecimal digits each, with blanks anywhere.
//   errors  Error: there are fewer; what is no digit
void readHexBytes(std::istream& text, std::uint64_t count, const std::filesystem::path& path,
                  const Sink& sink);

}  // namespace sonoskin
