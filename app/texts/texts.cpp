#include "app/texts/texts.h"

#include <unordered_map>

#include "app/texts/text_table.h"

namespace sonoskin {
namespace {

using Words = std::unordered_map<std::string_view, const char*>;

Language used = Language::english;

Words wordsOf(const char* Text::*language) {
  Words words;
  for (const Text& text : textTable()) words.emplace(text.english, text.*language);
  return words;
}

}  // namespace

void useLanguage(Language language) { used = language; }

const char* tr(const char* english) {
  if (used == Language::english) return english;
  static const Words german = wordsOf(&Text::german), french = wordsOf(&Text::french);
  const Words& words = used == Language::german ? german : french;
  const auto found = words.find(english);
  return found == words.end() ? english : found->second;
}

}  // namespace sonoskin
