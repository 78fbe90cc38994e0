#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace sonoskin {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

// ByteSink: collects the bytes of a little-endian binary file.
class ByteSink {
 public:
  explicit ByteSink(std::size_t expected = 0) { bytes_.reserve(expected); }

  void text(std::string_view text) { raw(text.data(), text.size()); }
  template <class T>
  void number(const T& value) {
    raw(&value, sizeof value);
  }
  template <class T>
  void array(const std::vector<T>& values) {
    raw(values.data(), values.size() * sizeof(T));
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  void raw(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }

  std::vector<std::uint8_t> bytes_;
};

}  // namespace sonoskin
