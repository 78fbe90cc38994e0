#include "app/texts/language_choice.h"

#include <cstdlib>
#include <optional>
#include <string_view>

namespace sonoskin {
namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

std::string_view locale() {
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (const std::string_view value = variable(name); !value.empty()) return value;
  return "C";
}

// "de_AT.UTF-8" is German.
std::optional<Language> languageNamed(std::string_view locale) {
  const std::string_view name = locale.substr(0, locale.find_first_of("_.@"));
  if (name == "en") return Language::english;
  if (name == "de") return Language::german;
  if (name == "fr") return Language::french;
  return {};
}

}  // namespace

Language systemLanguage() {
  const std::string_view place = locale();
  if (place == "C" || place.starts_with("C.") || place == "POSIX") return Language::english;
  std::string_view wanted = variable("LANGUAGE");
  while (!wanted.empty()) {
    const std::size_t end = std::min(wanted.find(':'), wanted.size());
    if (const auto known = languageNamed(wanted.substr(0, end))) return *known;
    wanted.remove_prefix(std::min(end + 1, wanted.size()));
  }
  return languageNamed(place).value_or(Language::english);
}

Language languageOf(LanguageChoice choice) {
  switch (choice) {
    case LanguageChoice::system:
      return systemLanguage();
    case LanguageChoice::english:
      return Language::english;
    case LanguageChoice::german:
      return Language::german;
    case LanguageChoice::french:
      return Language::french;
  }
  return Language::english;
}

}  // namespace sonoskin
