#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sonoskin {

// checkOutputFile: refuses, before any work, a name that could not be written at its end: an extension that
// is not in the list, a folder that does not exist, a name that is a folder.
//   errors  Error (usage)
void checkOutputFile(const std::filesystem::path& file, const std::vector<std::string>& extensions);

}  // namespace sonoskin
