#include "app/batch/obsolete_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"

namespace sonoskin {

std::vector<std::string> obsoleteFiles(const std::filesystem::path& folder,
                                       const std::vector<std::string>& files) {
  static const std::regex kOurs(fmt::format(
      R"((skin|mesh|volume|slices)\.png|(mesh|skin|print)\.({0}|mtl)|skin_\w+\.png|)"
      R"(mesh_\d+\.({0}|mtl)|film\.mp4|truth\.ply|points\.ply|(scan|scan_mask|classified|thinned)\.({1}))",
      fmt::join(extensionWords(FileKind::writtenMesh), "|"),
      fmt::join(extensionWords(FileKind::writtenVolume), "|")));
  std::vector<std::string> obsolete;
  nlohmann::json earlier;
  try {
    earlier = nlohmann::json::parse(readText(folder / "report.json"), nullptr, false);
  } catch (const Error&) {
    return obsolete;  // there was no earlier run, or its report is none
  }
  if (!earlier.is_object() || !earlier.contains("files") || !earlier["files"].is_array()) return obsolete;
  for (const nlohmann::json& name : earlier["files"])
    if (name.is_string() && std::regex_match(name.get<std::string>(), kOurs) &&
        std::ranges::count(files, name.get<std::string>()) == 0)
      obsolete.push_back(name.get<std::string>());
  return obsolete;
}

}  // namespace sonoskin
