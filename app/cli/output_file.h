#pragma once

#include <filesystem>

#include "core/io/file_formats.h"

namespace sonoskin {

// checkOutputFile: refuses, before any work, a name that could not be written at its end: an ending
// that is none of the kind's, a folder that does not exist, a name that is a folder or too long.
//   errors  Error (usage)
void checkOutputFile(const std::filesystem::path& file, FileKind kind);

}  // namespace sonoskin
