#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace sonoskin {

// Key: a 128-bit fingerprint (xxh3). Equal content gives equal keys on every run and machine.
struct Key {
  std::uint64_t high = 0, low = 0;
  friend bool operator==(const Key&, const Key&) = default;
  explicit operator bool() const { return high || low; }
  std::string hex() const;
};

// Hasher: fingerprints a sequence of values, in order.
class Hasher {
 public:
  explicit Hasher(std::string_view name) { add(name); }

  Hasher& add(std::string_view text);
  Hasher& add(const Key& key);
  Hasher& addBytes(const void* data, std::size_t bytes);
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T> Hasher& add(T value) {
    return addBytes(&value, sizeof value);
  }
  template <class T>
  Hasher& add(std::span<const T> values) {
    return add(values.size()).addBytes(values.data(), values.size_bytes());
  }
  Key key() const { return state_; }

 private:
  Key state_;
};

}  // namespace sonoskin
