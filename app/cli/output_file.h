#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/file_formats.h"

namespace sonoskin {

// checkOutputFile: refuses, before any work, a name that could not be written at its end: an ending
// that is none of the kind's, a folder that does not exist, a name that is a folder or too long.
//   errors  Error (usage)
void checkOutputFile(const std::filesystem::path& file, FileKind kind);

// refuseInputs: refuses a name that is one of the files that are read, by whatever way it leads there.
//   read    empty names are none
//   errors  Error (usage)
void refuseInputs(const std::filesystem::path& file, const std::vector<std::string>& read);

}  // namespace sonoskin
