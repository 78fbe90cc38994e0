// The window's texts in other languages; tests/tools/check_texts.py looks for gaps.
#include "app/texts/texts.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>
#include <stdlib.h>

#include "app/texts/language_choice.h"
#include "app/texts/text_table.h"
#include "app/workspace/commands.h"
#include "app/workspace/settings.h"
#include "app/workspace/workspace.h"
#include "tests/support/imgui_test.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

class Texts : public testing::Test {
 protected:
  ~Texts() override { useLanguage(Language::english); }
};

TEST_F(Texts, AreThoseOfTheLanguageInUse) {
  EXPECT_STREQ(tr("Cancel"), "Cancel");
  useLanguage(Language::german);
  EXPECT_STREQ(tr("Cancel"), "Abbrechen");
  EXPECT_EQ(trf("{} of {}", 3, 8), "3 von 8");
  EXPECT_STREQ(tr("what no table has"), "what no table has");
  useLanguage(Language::french);
  EXPECT_STREQ(tr("Cancel"), "Annuler");
}

TEST_F(Texts, KeepTheIdentityOfTheirWidgets) {
  const std::string english = trId("File");
  useLanguage(Language::french);
  EXPECT_EQ(trId("File"), "Fichier###File");
  EXPECT_EQ(english, "File###File");
}

// Of core, which knows English alone.
TEST_F(Texts, OfSentencesAreFoundByTheirWords) {
  useLanguage(Language::german);
  EXPECT_EQ(trSentence("The scan has 12 time steps; the first is used."),
            "Die Aufnahme hat 12 Zeitschritte; der erste wird verwendet.");
  EXPECT_EQ(trSentence("Saved /tmp/a of b.ply"), "Gespeichert: /tmp/a of b.ply");
  EXPECT_EQ(trSentence("Opening face"), "Öffnen von face");  // a name is no word
  EXPECT_EQ(trSentence("there is but one grey in what was recorded, and so no surface; open another scan"),
            "in der Aufnahme ist nur ein Grauwert, und daher keine Oberfläche; öffnen Sie eine andere");
  EXPECT_EQ(trSentence("There is but one grey in what was recorded, and so no surface; open another scan."),
            "In der Aufnahme ist nur ein Grauwert, und daher keine Oberfläche; öffnen Sie eine andere.");
  EXPECT_EQ(trSentence("This sentence stands nowhere."), "This sentence stands nowhere.");
  useLanguage(Language::english);
  EXPECT_EQ(trSentence("Saved a.ply"), "Saved a.ply");
}

TEST_F(Texts, BeginWithACapitalOfAnyLanguage) {
  EXPECT_EQ(capitalised("skin"), "Skin");
  EXPECT_EQ(capitalised("über"), "Über");
  EXPECT_EQ(capitalised("écho"), "Écho");
  EXPECT_EQ(capitalised("÷"), "÷");
  EXPECT_EQ(capitalised("Ärger"), "Ärger");
  EXPECT_EQ(capitalised(""), "");
}

class SystemLanguage : public Texts {
 protected:
  SystemLanguage() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG", "LANGUAGE"}) {
      const char* value = ::getenv(name);
      before_.emplace_back(name, value ? std::optional<std::string>(value) : std::nullopt);
      ::unsetenv(name);
    }
  }
  ~SystemLanguage() override {
    for (const auto& [name, value] : before_) value ? ::setenv(name, value->c_str(), 1) : ::unsetenv(name);
  }
  static void set(const char* name, const char* value) { ::setenv(name, value, 1); }

 private:
  std::vector<std::pair<const char*, std::optional<std::string>>> before_;
};

TEST_F(SystemLanguage, IsReadAsGettextReadsIt) {
  EXPECT_EQ(systemLanguage(), Language::english);
  set("LANG", "de_AT.UTF-8");
  EXPECT_EQ(systemLanguage(), Language::german);
  set("LC_MESSAGES", "fr_CA");
  EXPECT_EQ(systemLanguage(), Language::french);
  set("LC_ALL", "nl_NL.UTF-8");
  EXPECT_EQ(systemLanguage(), Language::english);
  set("LANGUAGE", "it:de:fr");
  EXPECT_EQ(systemLanguage(), Language::german);
  set("LC_ALL", "C.UTF-8");
  EXPECT_EQ(systemLanguage(), Language::english);
  set("LC_ALL", "");
  set("LANGUAGE", "");
  EXPECT_EQ(systemLanguage(), Language::french);
}

TEST_F(SystemLanguage, GivesWayToTheOneThatIsChosen) {
  set("LANG", "de_DE.UTF-8");
  EXPECT_EQ(languageOf(LanguageChoice::system), Language::german);
  EXPECT_EQ(languageOf(LanguageChoice::french), Language::french);
  EXPECT_EQ(languageOf(LanguageChoice::english), Language::english);
}

TEST_F(Texts, LanguageIsKept) {
  const test::TempFolder folder;
  Settings settings;
  settings.language = LanguageChoice::french;
  writeSettings(folder / "settings.json", settings);
  EXPECT_EQ(readSettings(folder / "settings.json").language, LanguageChoice::french);
  EXPECT_EQ(readSettings(folder / "none.json").language, LanguageChoice::system);
}

class TextLetters : public ui::ImGuiTest {
 protected:
  TextLetters() : ImGuiTest({100, 100}) {}
};

// A letter that a font lacks is a question mark.
TEST_F(TextLetters, AreInAllFonts) {
  for (const std::span<const Text> table : textTables())
    for (const Text& text : table)
      for (const char* at : {text.german, text.french})
        for (unsigned int letter = 0; *at;) {
          at += ImTextCharFromUtf8(&letter, at, nullptr);
          for (ImFont* font : ImGui::GetIO().Fonts->Fonts)
            ASSERT_TRUE(letter == '\n' || font->FindGlyphNoFallback(ImWchar(letter)))
                << text.english << " U+" << std::hex << letter;
        }
}

}  // namespace
}  // namespace sonoskin
