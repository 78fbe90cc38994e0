#include "core/io/headers/meta_fields.h"

#include "core/base/error.h"
#include "core/io/headers/data_files.h"

namespace sonoskin {
namespace fs = std::filesystem;

MetaFields parseMeta(std::string_view text, const fs::path& path) {
  MetaFields meta;
  HeaderLines lines(text, path);
  for (int number = 1; const auto line = lines.next(); ++number) {
    if (trimmed(*line).empty()) continue;
    const std::size_t equals = line->find('=');
    if (equals == std::string_view::npos) break;
    const std::string key(trimmed(line->substr(0, equals)));
    // MetaIO ends a key at ':' too, and takes the last of two equal keys for some fields and the first for
    // others.
    require(!key.empty() && key.find(':') == std::string::npos,
            "{} has a key in line {} that programs read in different ways; save it again without.",
            path.string(), number);
    require(meta.keys.emplace(key, trimmed(line->substr(equals + 1))).second,
            "{} has the key of line {} there twice; save it again without.", path.string(), number);
    if (key != "ElementDataFile") continue;
    meta.bytes = lines.position();
    if (isFileList(meta[key])) meta.files = listedFiles(lines, path);
    return meta;
  }
  throw Error(fmt::format("{} is not a complete MetaImage header; get a fresh copy.", path.string()));
}

bool metaIsTrue(std::string_view text) {
  return text == "1" || text.starts_with('T') || text.starts_with('t');
}

}  // namespace sonoskin
