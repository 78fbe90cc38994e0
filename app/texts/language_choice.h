#pragma once

#include <array>

#include "app/texts/texts.h"

namespace sonoskin {

// LanguageChoice: what a person wants; system: what the machine is set to.
enum class LanguageChoice { system, english, german, french };
constexpr std::array<const char*, 4> enumNames(LanguageChoice) {
  return {"system", "english", "german", "french"};
}

// systemLanguage: of the environment, as gettext reads it: the first of LC_ALL, LC_MESSAGES and LANG that is set tells the
// locale; where that is not "C", the first of the list LANGUAGE that is known counts before it. What is not known is English.
Language systemLanguage();

Language languageOf(LanguageChoice choice);

}  // namespace sonoskin
