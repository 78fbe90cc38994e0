#include "core/io/headers/nrrd_fields.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/io/headers/data_files.h"

namespace sonoskin {
namespace fs = std::filesystem;

NrrdFields parseNrrd(std::string_view text, const fs::path& path) {
  NrrdFields nrrd;
  HeaderLines lines(text, path);
  lines.next();  // the magic
  for (int number = 2; const auto line = lines.next(); ++number) {
    nrrd.bytes = lines.position();
    nrrd.ended = line->empty();
    if (nrrd.ended) break;
    const std::size_t colon = line->find(':');
    if (line->starts_with('#') || colon == std::string_view::npos) continue;  // comments
    if (line->substr(colon).starts_with(":=")) {
      nrrd.keys.emplace(line->substr(0, colon), line->substr(colon + 2));
      continue;
    }
    std::string name = lowerCase(line->substr(0, colon));
    std::erase(name, ' ');
    const std::string_view value = trimmed(line->substr(colon + 1));
    require(nrrd.fields.emplace(name, value).second,
            "{} has the field of line {} there twice; get a fresh copy.", path.string(), number);
    if (name == "datafile" && isFileList(value)) {
      nrrd.files = listedFiles(lines, path);
      break;
    }
  }
  return nrrd;
}

std::vector<std::string> quotedWords(std::string_view text) {
  std::vector<std::string> found;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const bool quoted = text.front() == '"';
    if (quoted) text.remove_prefix(1);
    const std::size_t end = std::min(quoted ? text.find('"') : text.find_first_of(" \t"), text.size());
    found.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return found;
}

std::vector<NrrdVector> nrrdVectors(std::string_view text, const fs::path& path) {
  std::vector<NrrdVector> vectors;
  const auto refuse = [&] {
    throw Error(
        fmt::format("The direction of the axes in {} is not finite; correct the header.", path.string()));
  };
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const bool bracket = text.front() == '(';
    const std::size_t end = bracket ? text.find(')') : std::min(text.find_first_of(" \t("), text.size());
    if (end == std::string_view::npos || vectors.size() > 16) refuse();
    if (!bracket) {
      if (lowerCase(text.substr(0, end)) != "none") refuse();
      vectors.emplace_back();
      text.remove_prefix(end);
      continue;
    }
    std::string inside(text.substr(1, end - 1));
    std::replace(inside.begin(), inside.end(), ',', ' ');
    const auto numbers = parseNumbers<double>(inside);
    const auto finite = [](double v) { return std::isfinite(v); };
    if (!numbers || numbers->empty() || !std::all_of(numbers->begin(), numbers->end(), finite)) refuse();
    vectors.emplace_back(*numbers);
    text.remove_prefix(end + 1);
  }
  return vectors;
}

}  // namespace sonoskin
