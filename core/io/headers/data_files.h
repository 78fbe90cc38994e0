#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/header_text.h"

namespace sonoskin {

// The data files that a header names, one or, in NRRD and MetaImage, several. None may lie outside of the
// header's folder, and no sentence repeats a name: it stands in the header and may be a patient's.

// dataFileSize: bytes of such a file, which may be the header itself.
//   errors  Error: it is not there, is no ordinary file, is empty or may not be read
std::uintmax_t dataFileSize(const std::filesystem::path& file, const std::filesystem::path& header);

// isFileList: whether the text says that names follow, one a line: its first word is "LIST", in large letters
// as in Teem and MetaIO.
bool isFileList(std::string_view text);

// listedFiles: the names in all lines that are left.
//   errors  Error: more than 65535
std::vector<std::string> listedFiles(HeaderLines& lines, const std::filesystem::path& header);

// FilePattern: names made of numbers, such as "slice%03d.raw 1 40 1".
struct FilePattern {
  std::string name;
  long first = 0, last = 0, step = 1;
};

// isPattern: whether the text names files by numbers: its first word has a "%" and others follow. What
// follows may be more than the numbers of the pattern.
bool isPattern(std::string_view text);

// patternOf: the pattern in the first four words; a step that is not there is 1.
//   errors  Error: it is none, or means more than 65535 files
FilePattern patternOf(std::string_view text, const std::filesystem::path& header);

// namesOf: the names that a pattern means.
std::vector<std::string> namesOf(const FilePattern& pattern);

}  // namespace sonoskin
