#include "app/document/command_text.h"

#include <algorithm>
#include <string_view>

namespace sonoskin {
namespace {

bool isPlain(unsigned char c) {
  constexpr std::string_view kPlain = "_-+=:,./@%";
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c >= 0x80 ||
         kPlain.find(char(c)) != std::string_view::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::ranges::all_of(word, isPlain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

CommandText& CommandText::word(const std::string& word) {
  text_ += " " + quoted(word);
  return *this;
}

CommandText& CommandText::option(const std::string& name, const std::string& value) {
  text_ += " " + name;
  return word(value);
}

}  // namespace sonoskin
