#include "app/cli/output_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "core/base/error.h"

namespace sonoskin {

void checkOutputFile(const std::filesystem::path& file, const std::vector<std::string>& extensions) {
  const auto refuse = [&](const std::string& why) {
    throw Error(fmt::format("{}: {}", file.string(), why), Error::Kind::usage);
  };
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  const auto fits = [&](const std::string& extension) {
    return name.size() > extension.size() && name.ends_with(extension);
  };
  if (std::ranges::none_of(extensions, fits))
    refuse(fmt::format("the name of the output must end in {}", fmt::join(extensions, ", ")));
  if (std::filesystem::is_directory(file)) refuse("is a folder, not a file");
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder)) refuse("its folder does not exist");
}

}  // namespace sonoskin
