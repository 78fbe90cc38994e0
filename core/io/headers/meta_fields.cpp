#include "core/io/headers/meta_fields.h"

#include "core/base/error.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostFiles = 65535;

void takeFiles(HeaderLines& lines, MetaFields& meta, const fs::path& path) {
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    require(meta.files.size() < kMostFiles, "{} names more than {} data files; save it as one file.",
            path.string(), kMostFiles);
    meta.files.emplace_back(trimmed(*line));
  }
}

}  // namespace

MetaFields parseMeta(std::string_view text, const fs::path& path) {
  MetaFields meta;
  HeaderLines lines(text, path);
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    const std::size_t equals = line->find('=');
    if (equals == std::string_view::npos) break;
    const std::string key(trimmed(line->substr(0, equals)));
    // MetaIO ends a key at ':' too, and takes the last of two equal keys for some fields and the first for
    // others.
    require(!key.empty() && key.find(':') == std::string::npos,
            "{} has a line \"{}\" that programs read in different ways; save it again without.",
            path.string(), key.substr(0, 20));
    require(meta.keys.emplace(key, trimmed(line->substr(equals + 1))).second,
            "{} has the line \"{}\" there twice; save it again without.", path.string(), key.substr(0, 20));
    if (key != "ElementDataFile") continue;
    meta.bytes = lines.position();
    if (lowerCase(meta[key].substr(0, 4)) == "list") takeFiles(lines, meta, path);
    return meta;
  }
  throw Error(fmt::format("{} is not a complete MetaImage header; get a fresh copy.", path.string()));
}

bool metaIsTrue(std::string_view text) {
  return text == "1" || text.starts_with('T') || text.starts_with('t');
}

}  // namespace sonoskin
