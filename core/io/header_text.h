#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/volume/scan.h"

// Small helpers shared by the parsers of text headers.
namespace sonoskin {

std::string_view trimmed(std::string_view text);
std::string lowerCase(std::string_view text);

// words: the parts of the text between blanks.
std::vector<std::string_view> words(std::string_view text);

// parseNumber: the whole text as one number, or nothing.
template <class T>
std::optional<T> parseNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  T value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

// isFinite: whether the whole text is one finite number.
bool isFinite(std::string_view text);

// parseNumbers: every word as a number, or nothing if one is not.
template <class T>
std::optional<std::vector<T>> parseNumbers(std::string_view text) {
  std::vector<T> values;
  for (const std::string_view word : words(text)) {
    const std::optional<T> value = parseNumber<T>(word);
    if (!value) return {};
    values.push_back(*value);
  }
  return values;
}

// HeaderLines: gives the lines of a header one by one.
class HeaderLines {
 public:
  HeaderLines(std::string_view text, const std::filesystem::path& path) : text_(text), path_(path) {}
  // next: the next line without its end ("\n" or "\r\n"); nothing at the end of the text.
  //   errors   Error: it holds control characters, at which other readers may end a line
  std::optional<std::string_view> next();
  std::size_t position() const { return at_; }  // of the line after the last one given

 private:
  std::string_view text_;
  const std::filesystem::path& path_;
  std::size_t at_ = 0;
};

// readHeaderText: the start of a file, long enough for any header that we accept (16 MiB).
//   errors  as readBytes
std::string readHeaderText(const std::filesystem::path& path);

// besideHeader: the path of a data file that a header names.
//   errors  Error: the name leads out of the header's folder, which a header from a stranger must not do
std::filesystem::path besideHeader(const std::filesystem::path& header, std::string_view name);

// The keys under which our files keep what NRRD and MetaImage have no field for.
inline constexpr const char* kBeamAxisKey = "sonoskin_beam_axis";
inline constexpr const char* kBeamUpKey = "sonoskin_beam_up";
inline constexpr const char* kBeamApexKey = "sonoskin_beam_apex";
inline constexpr const char* kRangeKey = "sonoskin_range";

using HeaderKeys = std::map<std::string, std::string, std::less<>>;

// beamFromKeys: the beam that the keys describe; nothing where they are missing or make no sense.
std::optional<Beam> beamFromKeys(const HeaderKeys& keys);
// rangeFromKeys: the values that mean 0 and 1; nothing where the key is missing or makes no sense.
std::optional<std::pair<double, double>> rangeFromKeys(const HeaderKeys& keys);

}  // namespace sonoskin
