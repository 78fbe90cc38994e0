#include "core/io/text_keys.h"

#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;

KeyText::KeyText(const fs::path& path, char between) : path_(path) {
  constexpr std::uintmax_t kMost = 1u << 20;
  const std::string text = readText(path, kMost);
  HeaderLines lines(text, path);
  while (const auto line = lines.next()) {
    const std::size_t cut = line->find(between);
    if (cut == std::string_view::npos) continue;
    values_.emplace(lowerCase(trimmed(line->substr(0, cut))), trimmed(line->substr(cut + 1)));
  }
}

std::optional<std::string> KeyText::valueOf(std::string_view key) const {
  const auto found = values_.find(lowerCase(key));
  if (found == values_.end()) return {};
  return found->second;
}

double KeyText::numberOf(std::string_view key) const {
  const auto number = parseNumber<double>(valueOf(key).value_or(""));
  require(number && std::isfinite(*number), "{} gives no number for {}; get a fresh copy.", path_.string(),
          key);
  return *number;
}

std::optional<std::array<double, 3>> KeyText::threeOf(std::string_view key) const {
  const auto text = valueOf(key);
  if (!text) return {};
  const auto numbers = parseNumbers<double>(*text);
  require(numbers && numbers->size() == 3 && std::isfinite((*numbers)[0]) && std::isfinite((*numbers)[1]) &&
              std::isfinite((*numbers)[2]),
          "{} gives no three numbers for {}; get a fresh copy.", path_.string(), key);
  return std::array{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

}  // namespace sonoskin
