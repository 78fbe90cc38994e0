#include "core/io/header_text.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/io/file_bytes.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr std::uintmax_t kMaxHeaderBytes = 16u << 20;

// Three finite numbers, or nothing.
std::optional<glm::dvec3> vectorOf(const HeaderKeys& keys, const char* key) {
  const auto found = keys.find(key);
  if (found == keys.end()) return {};
  const auto v = parseNumbers<double>(found->second);
  if (!v || v->size() != 3 || !std::all_of(v->begin(), v->end(), [](double x) { return std::isfinite(x); }))
    return {};
  return glm::dvec3((*v)[0], (*v)[1], (*v)[2]);
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = char(c + 'a' - 'A');
  return lower;
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> found;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    found.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kBlanks, end);
  }
  return found;
}

bool isFinite(std::string_view text) {
  const auto number = parseNumber<double>(text);
  return number && std::isfinite(*number);
}

std::optional<std::string_view> HeaderLines::next() {
  if (at_ >= text_.size()) return {};
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string_view line = text_.substr(at_, end - at_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  at_ = std::min(end + 1, text_.size());
  require(std::none_of(line.begin(), line.end(), [](unsigned char c) { return c < ' ' && c != '\t'; }),
          "The header of {} is not text; get a fresh copy.", path_.string());
  return line;
}

std::string readHeaderText(const fs::path& path) {
  const std::vector<std::uint8_t> bytes = readBytes(path, kMaxHeaderBytes);
  return std::string(bytes.begin(), bytes.end());
}

fs::path besideHeader(const fs::path& header, std::string_view name) {
  // Links inside the folder are the person's own doing; names that lead out of it are the file's.
  const fs::path plain = fs::path(name).lexically_normal();
  require(!plain.empty() && plain.is_relative() && *plain.begin() != fs::path(".."),
          "{} names a data file outside of its own folder; put both into one folder and correct the header.",
          header.string());
  return header.parent_path() / plain;
}

std::optional<Beam> beamFromKeys(const HeaderKeys& keys) {
  const std::optional<glm::dvec3> axis = vectorOf(keys, kBeamAxisKey);
  if (!axis || !(glm::length(*axis) > 1e-6)) return {};
  Beam beam;
  beam.apex = vectorOf(keys, kBeamApexKey);
  beam.axis = glm::normalize(*axis);
  if (const auto up = vectorOf(keys, kBeamUpKey); up && glm::length(*up) > 1e-6)
    beam.up = glm::normalize(*up);
  return beam;
}

std::optional<std::pair<double, double>> rangeFromKeys(const HeaderKeys& keys) {
  const auto found = keys.find(kRangeKey);
  if (found == keys.end()) return {};
  const auto v = parseNumbers<double>(found->second);
  if (!v || v->size() != 2 || !std::isfinite((*v)[0]) || !std::isfinite((*v)[1]) || !((*v)[0] < (*v)[1]))
    return {};
  return std::pair{(*v)[0], (*v)[1]};
}

}  // namespace sonoskin
