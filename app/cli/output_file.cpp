#include "app/cli/output_file.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace sonoskin {

void checkOutputFile(const std::filesystem::path& file, FileKind kind) {
  const auto refuse = [&](fmt::format_string<std::string> sentence) {
    throw Error(fmt::format(sentence, file.string()), Error::Kind::usage);
  };
  requireFormat(kind, file);
  if (std::filesystem::is_directory(file))
    refuse("{} cannot be written, for a folder has that name; choose another one.");
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder))
    refuse("{} cannot be written, for its folder does not exist; make it first.");
}

}  // namespace sonoskin
