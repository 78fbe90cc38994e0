#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sonoskin {

// Several data files of one header, as NRRD and MetaImage name them. None may lie outside of the header's
// folder.

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
