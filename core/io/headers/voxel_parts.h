#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/io/headers/declared_data.h"

namespace sonoskin {

// Stretch: bytes of a file's numbers, counted over all of its parts, unpacked.
struct Stretch {
  std::uintmax_t first = 0, last = 0;
};

// readStretch: a stretch of the `all` bytes that the header declares, as they are stored, words turned into
// this machine's bytes.
//   input   path  of the header
//   errors  Error: a part is not there, ends before its share of all bytes, is damaged or no numbers;
//           Cancelled
std::vector<std::uint8_t> readStretch(const DeclaredData& data, const Stretch& stretch, std::uintmax_t all,
                                      const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
