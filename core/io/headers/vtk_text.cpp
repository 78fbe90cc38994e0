#include "core/io/headers/vtk_text.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/headers/number_types.h"
#include "core/io/headers/text_numbers.h"

namespace sonoskin {
namespace fs = std::filesystem;

VtkText::VtkText(const fs::path& path) : path_(path), file_(path, std::ios::binary), size_(fileSize(path)) {}

std::optional<std::string> VtkText::plainLine() {
  constexpr std::size_t kLongest = 1u << 20;
  std::string text;
  int c = file_.get();
  if (c == std::char_traits<char>::eof()) return {};
  for (; c != '\n' && c != std::char_traits<char>::eof(); c = file_.get()) {
    require(text.size() < kLongest && (c >= ' ' || c == '\t' || c == '\r'),
            "The header of {} is not text; get a fresh copy.", path_.string());
    text.push_back(char(c));
  }
  if (text.ends_with('\r')) text.pop_back();
  require(text.find('\r') == std::string::npos, "The header of {} is not text; get a fresh copy.",
          path_.string());
  file_.clear(file_.rdstate() & ~std::ios::failbit);
  return text;
}

std::optional<std::string> VtkText::line() {
  while (auto text = plainLine())
    if (!trimmed(*text).empty()) return std::string(trimmed(*text));
  return {};
}

std::uintmax_t VtkText::position() {
  if (file_.eof()) return size_;
  return std::uintmax_t(file_.tellg());
}

void VtkText::seek(std::uintmax_t position) {
  file_.clear();
  file_.seekg(std::streamoff(position));
}

void VtkText::skipNumbers(NumberType type, std::uint64_t count) {
  if (!binary) return readTextNumbers(file_, type, count, path_, [](auto) {});
  const std::uintmax_t at = position(), each = numberTypeBytes(type);
  require(at <= size_ && count <= (size_ - at) / each,
          "{} ends before all of its voxels; the copy is incomplete, get a fresh one.", path_.string());
  seek(at + count * each);
}

std::vector<double> VtkText::numbers(NumberType type, std::uint64_t count) {
  std::vector<std::uint8_t> bytes;
  require(count <= 65536, "{} has too many numbers in its header; get a fresh copy.", path_.string());
  if (binary) {
    const std::uintmax_t at = position();
    skipNumbers(type, count);
    seek(at);
    bytes.resize(std::size_t(count) * numberTypeBytes(type));
    file_.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
    for (std::size_t b = 0; b < bytes.size(); b += numberTypeBytes(type))
      if constexpr (std::endian::native == std::endian::little)
        std::reverse(bytes.begin() + std::ptrdiff_t(b),
                     bytes.begin() + std::ptrdiff_t(b + numberTypeBytes(type)));
  } else {
    readTextNumbers(file_, type, count, path_, [&](std::span<const std::uint8_t> came) {
      bytes.insert(bytes.end(), came.begin(), came.end());
    });
  }
  std::vector<double> values;
  visitNumber(type, [&](auto number) {
    for (std::size_t b = 0; b < bytes.size(); b += sizeof number) {
      std::memcpy(&number, bytes.data() + b, sizeof number);
      values.push_back(double(number));
    }
  });
  return values;
}

}  // namespace sonoskin
