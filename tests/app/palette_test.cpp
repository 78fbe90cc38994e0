#include "app/workspace/palette_entries.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/workspace/word_match.h"
#include "app/workspace/workspace.h"

namespace sonoskin {
namespace {

TEST(WordMatch, WordsAreMadeOfBeginnings) {
  const char* title = "Reconstruct surface (again)";
  for (const char* words :
       {"", "  ", "r", "reconstruct", "rec sur", "recsur", "rs", "RS", "sur rec", "again", "rsa"})
    EXPECT_TRUE(misfit(words, title)) << words;
  for (const char* words : {"construct", "sr", "rec x", "surfaces", "rr"})
    EXPECT_FALSE(misfit(words, title)) << words;
  EXPECT_TRUE(misfit("ü", "Über alles") || misfit("Ü", "Über alles")) << "letters beyond ASCII";
}

TEST(WordMatch, FewerJumpsAndEarlierWordsFitBetter) {
  EXPECT_LT(*misfit("mesh", "Mesh to print"), *misfit("mesh", "Save mesh"));
  EXPECT_LT(*misfit("save", "Save all"), *misfit("save", "Set all values evenly"));
  EXPECT_LT(*misfit("sm", "Small"), *misfit("sm", "Save mesh"));
}

std::vector<std::string> idsFor(const char* words) {
  const Workspace workspace{Parameters()};
  std::vector<std::string> ids;
  for (const PaletteEntry& entry : paletteEntries(words, workspace)) ids.push_back(entry.id);
  return ids;
}

TEST(Palette, FindsWhatIsMeant) {
  const std::pair<const char*, const char*> meant[] = {{"save mesh", "file.saveMesh"},
                                                       {"quit", "file.quit"},
                                                       {"undo", "edit.undo"},
                                                       {"rec surf", "surface.reconstruct"},
                                                       {"crop whole", "region.resetBox"},
                                                       {"open ph", "file.phantom"},
                                                       {"help about", "help.about"},
                                                       {"beta", "classification.beta"},
                                                       {"edge str", "classification.gamma"},
                                                       {"v_iso", "classification.isoValue"},
                                                       {"iso val", "classification.isoValue"}};
  for (const auto& [words, id] : meant) {
    const std::vector<std::string> found = idsFor(words);
    ASSERT_FALSE(found.empty()) << words;
    EXPECT_EQ(found.front(), id) << words;
  }
  EXPECT_TRUE(idsFor("xylophone").empty());
}

TEST(Palette, WithoutWordsAllCommandsInTheirOrder) {
  const std::vector<std::string> found = idsFor(" ");
  ASSERT_EQ(found.size(), commands().size());
  for (std::size_t n = 0; n < found.size(); ++n) EXPECT_EQ(found[n], commands()[n].id);
}

TEST(Palette, OpensTheStepOfAParameter) {
  Workspace workspace{Parameters()};
  paletteEntries("smoothness", workspace).front().run(workspace);
  EXPECT_EQ(workspace.step, Step::surface);
  EXPECT_EQ(workspace.help.wantedRow, "reconstruction.smoothness");
}

TEST(Palette, SaysWhatACommandWaitsFor) {
  const Workspace workspace{Parameters()};
  EXPECT_STREQ(whatLacks(command("file.saveMesh"), workspace), "there is no surface yet");
  EXPECT_STREQ(whatLacks(command("view.raw"), workspace), "no scan is open");
  EXPECT_STREQ(whatLacks(command("file.open"), workspace), "");
}

}  // namespace
}  // namespace sonoskin
