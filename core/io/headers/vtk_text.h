#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/io/stored_volume.h"

namespace sonoskin {

// VtkText: walks over a VTK legacy file, whose lines and blocks of numbers follow one another.
class VtkText {
 public:
  // errors  as fileSize
  explicit VtkText(const std::filesystem::path& path);

  // line: the next line with any words, without blanks around it; nothing at the end of the file.
  //   errors  Error: it has more than a megabyte, or holds no text
  std::optional<std::string> line();
  // plainLine: the next line, empty or not.
  std::optional<std::string> plainLine();
  std::uintmax_t position();  // of what comes next, in bytes
  void seek(std::uintmax_t position);

  // skipNumbers: passes over a block of numbers, in big-endian bytes or as words.
  //   errors  Error: the file ends within
  void skipNumbers(NumberType type, std::uint64_t count);
  // numbers: the same, as doubles; a block of at most 65536.
  std::vector<double> numbers(NumberType type, std::uint64_t count);

  bool binary = false;

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::uintmax_t size_;
};

}  // namespace sonoskin
