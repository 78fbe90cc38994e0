#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace sonoskin {

// zipFiles: the bytes of a ZIP archive of named files, packed with deflate, with fixed dates so that equal content
// gives equal bytes.
//   errors  Error: 4 GB or more
std::vector<std::uint8_t> zipFiles(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace sonoskin
