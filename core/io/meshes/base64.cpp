#include "core/io/meshes/base64.h"

#include <array>

namespace sonoskin {
namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNone = 255;

constexpr std::array<std::uint8_t, 256> valuesOfLetters() {
  std::array<std::uint8_t, 256> values{};
  values.fill(kNone);
  for (std::size_t v = 0; v < kLetters.size(); ++v) values[std::uint8_t(kLetters[v])] = std::uint8_t(v);
  return values;
}

bool isBlank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

std::string toBase64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < 3; ++b) bits = bits << 8 | (b < count ? bytes[i + b] : 0u);
    for (std::size_t c = 0; c < 4; ++c) text += c <= count ? kLetters[bits >> (18 - 6 * c) & 63] : '=';
  }
  return text;
}

std::optional<std::vector<std::uint8_t>> fromBase64(std::string_view text) {
  static constexpr std::array<std::uint8_t, 256> kValues = valuesOfLetters();
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  std::size_t letters = 0, padding = 0;
  for (const char c : text) {
    if (isBlank(c)) continue;
    if (c == '=') {
      ++padding;
      continue;
    }
    const std::uint8_t value = kValues[std::uint8_t(c)];
    if (value == kNone || padding > 0) return {};
    bits = bits << 6 | value;
    if (++letters % 4 == 0)
      for (const int shift : {16, 8, 0}) bytes.push_back(std::uint8_t(bits >> shift));
  }
  const std::size_t over = letters % 4;
  if (over == 1 || padding != (4 - over) % 4) return {};
  if (over >= 2) bytes.push_back(std::uint8_t(bits >> (over == 2 ? 4 : 10)));
  if (over == 3) bytes.push_back(std::uint8_t(bits >> 2));
  return bytes;
}

}  // namespace sonoskin
