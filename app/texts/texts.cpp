#include "app/texts/texts.h"

#include <unordered_map>

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

using Words = std::unordered_map<std::string_view, const char*>;

Language used = Language::english;

Words wordsOf(const char* Text::*language) {
  Words words;
  for (const std::span<const Text> table : textTables())
    for (const Text& text : table) words.emplace(text.english, text.*language);
  return words;
}

// Null where there is none.
const char* find(std::string_view english) {
  if (used == Language::english) return nullptr;
  static const Words german = wordsOf(&Text::german), french = wordsOf(&Text::french);
  const Words& words = used == Language::german ? german : french;
  const auto found = words.find(english);
  return found == words.end() ? nullptr : found->second;
}

}  // namespace

void useLanguage(Language language) { used = language; }

Language usedLanguage() { return used; }

const char* tr(const char* english) {
  const char* found = find(english);
  return found ? found : english;
}

std::string tr(std::string_view english) {
  const char* found = find(english);
  return found ? found : std::string(english);
}

std::string trId(const char* english) { return fmt::format("{}###{}", tr(english), english); }

// Letters of Latin-1 are two bytes, small ones 0x20 behind their capitals.
std::string capitalised(std::string_view text) {
  std::string result(text);
  const auto byte = [&](std::size_t n) { return static_cast<unsigned char>(result[n]); };
  if (!result.empty() && byte(0) >= 'a' && byte(0) <= 'z') result[0] = static_cast<char>(byte(0) - 0x20);
  if (result.size() > 1 && byte(0) == 0xC3 && byte(1) >= 0xA0 && byte(1) != 0xB7 && byte(1) <= 0xBE)
    result[1] = static_cast<char>(byte(1) - 0x20);
  return result;
}

}  // namespace sonoskin
