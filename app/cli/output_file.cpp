#include "app/cli/output_file.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/shown_text.h"

namespace sonoskin {

void checkOutputFile(const std::filesystem::path& file, FileKind kind) {
  const auto refuse = [&](fmt::format_string<std::string> sentence) {
    throw Error(fmt::format(sentence, file.string()), Error::Kind::usage);
  };
  requireFormat(kind, file);
  std::error_code why;
  const std::filesystem::file_status there = std::filesystem::status(file, why);
  if (there.type() == std::filesystem::file_type::none)  // that cannot be told
    throw Error(fmt::format("{} cannot be written ({}); choose another name.", shownText(file.string()),
                            why.message()),
                Error::Kind::usage);
  if (std::filesystem::is_directory(there))
    refuse("{} cannot be written, for a folder has that name; choose another one.");
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder, why))
    refuse("{} cannot be written, for its folder does not exist; make it first.");
}

void refuseInputs(const std::filesystem::path& file, const std::vector<std::string>& read) {
  for (const std::string& input : read) {
    std::error_code none;
    if (!input.empty() && std::filesystem::equivalent(file, input, none))
      throw Error(
          fmt::format("--out {} is the file {} that is read; choose another name.", file.string(), input),
          Error::Kind::usage);
  }
}

}  // namespace sonoskin
