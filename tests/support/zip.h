#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace sonoskin::test {

// zipOf: a ZIP file of parts as they are, unpacked.  [APPNOTE 4.3]
inline std::string zipOf(const std::vector<std::pair<std::string, std::string>>& parts) {
  std::string file, directory;
  const auto number = [](std::string& to, std::uint64_t value, int bytes) {
    for (int b = 0; b < bytes; ++b) to += char(value >> (8 * b));
  };
  for (const auto& [name, bytes] : parts) {
    const std::size_t at = file.size();
    std::string facts;
    number(facts, 20, 2), number(facts, 0, 2), number(facts, 0, 2), number(facts, 0x21000000, 4);
    number(facts, crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), uInt(bytes.size())), 4);
    number(facts, bytes.size(), 4), number(facts, bytes.size(), 4);
    number(facts, name.size(), 2), number(facts, 0, 2);
    file += "PK\3\4" + facts + name + bytes;
    directory += "PK\1\2";
    number(directory, 20, 2);
    directory += facts;
    number(directory, 0, 2), number(directory, 0, 4), number(directory, 0, 4), number(directory, at, 4);
    directory += name;
  }
  std::string end = "PK\5\6";
  number(end, 0, 4), number(end, parts.size(), 2), number(end, parts.size(), 2);
  number(end, directory.size(), 4), number(end, file.size(), 4), number(end, 0, 2);
  return file + directory + end;
}

}  // namespace sonoskin::test
