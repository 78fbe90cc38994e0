#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace sonoskin {

// TextLines: the lines of a text one by one, whichever line ends it has: "\n", "\r\n", "\r", mixed.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // the mark of UTF-8
  }
  std::optional<std::string_view> next() {
    if (text_.empty()) return {};
    const std::size_t end = text_.find_first_of("\r\n");
    const std::string_view line = text_.substr(0, end);
    ++number_;
    if (end == std::string_view::npos)
      text_ = {};
    else
      text_.remove_prefix(end + (text_.substr(end).starts_with("\r\n") ? 2 : 1));
    return line;
  }
  std::size_t number() const { return number_; }  // of the line given last, from 1
  std::size_t left() const { return text_.size(); }

 private:
  std::string_view text_;
  std::size_t number_ = 0;
};

// takeWord: the first word of a line, which is taken off it; empty where there is none.
inline std::string_view takeWord(std::string_view& line) {
  constexpr std::string_view kBlanks = " \t\v\f";
  const std::size_t begin = line.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  const std::size_t end = line.find_first_of(kBlanks, begin);
  const std::string_view word = line.substr(begin, end - begin);
  line = end == std::string_view::npos ? std::string_view() : line.substr(end);
  return word;
}

}  // namespace sonoskin
