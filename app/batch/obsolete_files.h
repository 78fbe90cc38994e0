#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sonoskin {

// obsoleteFiles: files of an earlier run in a folder that the new one has none of: the report there names them. Nothing that
// is not called as results are is among them, whatever that report says.
//   files  those of the new run, without folders
std::vector<std::string> obsoleteFiles(const std::filesystem::path& folder,
                                       const std::vector<std::string>& files);

}  // namespace sonoskin
