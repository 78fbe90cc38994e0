#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace sonoskin {

// What a person reads in the window, in the language that is chosen. English texts name the others, in the tables beside this
// file. English stay: the command line, recipes and all other files, names of parameters as these have them, and sentences about
// one file that no table has. Tables of texts are English, and are looked up where they are drawn.

// Language: of the window's texts.
enum class Language { english, german, french };

// useLanguage: what tr() answers in from now on; the program begins in English. From the window's thread alone.
void useLanguage(Language language);
Language usedLanguage();

// tr: a text of the window in the language in use; the English text names it, and is the answer where the tables have no such
// text.
const char* tr(const char* english);
std::string tr(std::string_view english);

// trf: with what stands in the places of a text: trf("{} of {}", 3, 8).
template <class... Args>
std::string trf(const char* english, const Args&... args) {
  return fmt::format(fmt::runtime(tr(english)), args...);
}

// trId: a title whose identity for Dear ImGui is the same in all languages: "Datei###File".
std::string trId(const char* english);

// trSentence: of a sentence that was made elsewhere, in English, with all that stands in its places: the text of a table whose
// other words it has; as it is where there is none. A table's "the scan is small" is found by "The scan is small.", too.
std::string trSentence(std::string_view english);

// capitalised: with a capital first letter, also of é and ü.
std::string capitalised(std::string_view text);

}  // namespace sonoskin
