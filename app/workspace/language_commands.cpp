#include "app/workspace/command_tables.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

using W = Workspace;

template <LanguageChoice choice>
void choose(W& w) {
  w.settings.language = choice;
  w.keepSettings();
}

template <LanguageChoice choice>
bool isChoice(const W& w) {
  return w.settings.language == choice;
}

constexpr const char* kLanguage = "Language";

// Languages have their own names in all of them.
// clang-format off
const Command kCommands[] = {
  {"language.system", "As the system has it", Menu::view, {}, choose<LanguageChoice::system>, nullptr,
   isChoice<LanguageChoice::system>, false, kLanguage},
  {"language.english", "English", Menu::view, {}, choose<LanguageChoice::english>, nullptr, isChoice<LanguageChoice::english>,
   true, kLanguage},
  {"language.german", "Deutsch", Menu::view, {}, choose<LanguageChoice::german>, nullptr, isChoice<LanguageChoice::german>,
   false, kLanguage},
  {"language.french", "Français", Menu::view, {}, choose<LanguageChoice::french>, nullptr, isChoice<LanguageChoice::french>,
   false, kLanguage},
};
// clang-format on

}  // namespace

std::span<const Command> languageCommands() { return kCommands; }

}  // namespace sonoskin
