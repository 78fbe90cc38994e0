#pragma once

namespace sonoskin {

// Language: of the window's texts.
enum class Language { english, german, french };

// useLanguage: what tr() answers in from now on; the program begins in English. From the window's thread alone.
void useLanguage(Language language);

// tr: a text of the window in the language in use; the English text names it, and is the answer where the table has
// no such text. Texts with places for numbers keep them: fmt::format(fmt::runtime(tr("{} of {}")), ...).
const char* tr(const char* english);

}  // namespace sonoskin
