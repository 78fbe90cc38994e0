#pragma once

#include <filesystem>
#include <string>

namespace sonoskin {

// writePrivately: a small file for this user's eyes alone (mode 600), as writeAtomically; makes its folder where needed.
//   errors  Error (system): it cannot be written
void writePrivately(const std::filesystem::path& file, const std::string& text);

}  // namespace sonoskin
