#include "app/cli/output_file.h"

#include <fmt/format.h>

#include "core/base/error.h"

namespace sonoskin {

void checkOutputFile(const std::filesystem::path& file, FileKind kind) {
  const auto refuse = [&](const char* why) {
    throw Error(fmt::format("{} cannot be written: {}.", file.string(), why), Error::Kind::usage);
  };
  requireFormat(kind, file);
  if (std::filesystem::is_directory(file)) refuse("a folder has that name; choose another one");
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder)) refuse("its folder does not exist; make it first");
}

}  // namespace sonoskin
