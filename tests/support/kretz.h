#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

// Kretz files for tests, record by record.
namespace sonoskin::test {

// KretzWriter: bytes of a KRETZFILE 1.0, written without any of core/io.
class KretzWriter {
 public:
  explicit KretzWriter(const std::string& magic = "KRETZFILE 1.0   ") : bytes_(magic) {}

  KretzWriter& record(unsigned group, unsigned element, const std::string& payload) {
    number(group, 2);
    number(element, 2);
    number(unsigned(payload.size()), 4);
    bytes_ += payload;
    return *this;
  }
  KretzWriter& whole(unsigned group, unsigned element, unsigned value, int bytes = 2) {
    std::string payload;
    for (int b = 0; b < bytes; ++b) payload += char(value >> (8 * b) & 0xFF);
    return record(group, element, payload);
  }
  KretzWriter& values(unsigned group, unsigned element, const std::vector<double>& values) {
    return record(group, element,
                  {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
  }
  KretzWriter& dims(unsigned i, unsigned j, unsigned k, unsigned volume = 0) {
    whole(0xC000, volume << 8 | 1, i).whole(0xC000, volume << 8 | 2, j);
    return whole(0xC000, volume << 8 | 3, k);
  }
  // torus: a grid of 0.5 mm samples from 20 mm on, swept about an axis at 8 mm.
  KretzWriter& torus(const std::vector<double>& fan, const std::vector<double>& sweep) {
    values(0xC100, 1, {0.0005}).values(0xC200, 1, {40}).values(0xC200, 2, {-16});
    return values(0xC300, 1, sweep).values(0xC300, 2, fan);
  }
  KretzWriter& end() { return record(0xFFFF, 0xFFFF, ""); }

  const std::string& bytes() const { return bytes_; }
  std::span<const std::uint8_t> span() const {
    return {reinterpret_cast<const std::uint8_t*>(bytes_.data()), bytes_.size()};
  }

 private:
  void number(unsigned value, int bytes) {
    for (int b = 0; b < bytes; ++b) bytes_ += char(value >> (8 * b) & 0xFF);
  }
  std::string bytes_;
};

// ramp: `count` bytes that rise by one from `first`.
inline std::string ramp(int count, int first = 0) {
  std::string bytes;
  for (int n = 0; n < count; ++n) bytes += char(first + n);
  return bytes;
}

}  // namespace sonoskin::test
