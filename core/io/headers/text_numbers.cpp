#include "core/io/headers/text_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/header_text.h"
#include "core/io/headers/number_types.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLongest = 64;  // letters of a number
constexpr std::size_t kBuffered = 1u << 16;

[[noreturn]] void failTruncated(const fs::path& path) {
  throw Error(fmt::format("{} ends before all of its voxels; the copy is incomplete, get a fresh one.",
                          path.string()));
}
[[noreturn]] void failText(const fs::path& path) {
  throw Error(fmt::format("The voxels in {} are not all numbers; get a fresh copy.", path.string()));
}

bool isBlank(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// The next word; false at the end.
bool nextWord(std::streambuf& text, std::string& word, const fs::path& path) {
  int c = text.sgetc();
  while (isBlank(c)) c = text.snextc();
  word.clear();
  for (; c != std::char_traits<char>::eof() && !isBlank(c); c = text.snextc()) {
    if (word.size() >= kLongest) failText(path);
    word.push_back(char(c));
  }
  return !word.empty();
}

// Whole numbers may be written as "12.0" too.
template <class T>
std::optional<T> numberOf(const std::string& word) {
  if (const auto exact = parseNumber<T>(word)) return exact;
  if constexpr (std::is_integral_v<T>) {
    const auto real = parseNumber<double>(word);
    constexpr double kBeyond = 2.0 * double(std::numeric_limits<T>::max() / 2 + 1);
    if (real && *real == std::floor(*real) && *real >= double(std::numeric_limits<T>::min()) &&
        *real < kBeyond)
      return T(*real);
  } else if (const auto real = parseNumber<double>(word)) {
    return T(
        std::clamp(*real, -double(std::numeric_limits<T>::max()), double(std::numeric_limits<T>::max())));
  }
  return {};
}

}  // namespace

void readTextNumbers(std::istream& text, NumberType type, std::uint64_t count, const fs::path& path,
                     const Sink& sink) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kBuffered + sizeof(double));
  std::string word;
  visitNumber(type, [&](auto number) {
    for (std::uint64_t n = 0; n < count; ++n) {
      if (!nextWord(*text.rdbuf(), word, path)) failTruncated(path);
      const auto value = numberOf<decltype(number)>(word);
      if (!value) failText(path);
      bytes.resize(bytes.size() + sizeof number);
      std::memcpy(bytes.data() + bytes.size() - sizeof number, &*value, sizeof number);
      if (bytes.size() < kBuffered) continue;
      sink(bytes);
      bytes.clear();
    }
  });
  sink(bytes);
}

void readHexBytes(std::istream& text, std::uint64_t count, const fs::path& path, const Sink& sink) {
  std::streambuf& from = *text.rdbuf();
  const auto digit = [&] {
    int c = from.sbumpc();
    while (isBlank(c)) c = from.sbumpc();
    if (c == std::char_traits<char>::eof()) failTruncated(path);
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    failText(path);
  };
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kBuffered);
  for (std::uint64_t n = 0; n < count; ++n) {
    const int high = digit();
    bytes.push_back(std::uint8_t(high * 16 + digit()));
    if (bytes.size() < kBuffered) continue;
    sink(bytes);
    bytes.clear();
  }
  sink(bytes);
}

}  // namespace sonoskin
