#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace sonoskin {

// KeyText: a small text file of lines "key: value" or "key = value", of which only the keys that are asked for count.
class KeyText {
 public:
  //   between  what stands between key and value
  //   errors   Error: it is larger than any such header, holds control characters, or cannot be read
  KeyText(const std::filesystem::path& path, char between);

  // valueOf: without the blanks around; nothing where there is no such key. Capitals do not count.
  std::optional<std::string> valueOf(std::string_view key) const;
  // numberOf: a finite number.
  //   errors  Error: it is missing or no number
  double numberOf(std::string_view key) const;
  // threeOf: three finite numbers; nothing where there is no such key.
  //   errors  Error: they are no three numbers
  std::optional<std::array<double, 3>> threeOf(std::string_view key) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::map<std::string, std::string, std::less<>> values_;
};

}  // namespace sonoskin
