#include "app/widgets/nameless.h"

#include <gtest/gtest.h>

#include "app/widgets/message_log.h"

namespace sonoskin::ui {
namespace {

namespace fs = std::filesystem;

TEST(Nameless, NamesOfFilesAreLeftOut) {
  const std::vector<fs::path> chosen{"/data/Wilhelmina Featherstone/scan 3.nrrd"};
  const std::pair<const char*, const char*> cases[] = {
      {"Saved /data/Wilhelmina Featherstone/scan 3.nrrd", "Saved [file]"},
      {"scan 3.nrrd is saved, but its recipe is not.", "[file] is saved, but its recipe is not."},
      {"The scan 3 has no spacing.", "The [file] has no spacing."},
      {"Saved /data/Wilhelmina Featherstone/out/face.ply", "Saved [file]"},
      {"'IM_0001.dcm' cannot be read; use .nrrd or .mha.", "'[file]' cannot be read; use .nrrd or .mha."},
      {"The folder /home/anna/x: nothing is there.", "The folder [file]: nothing is there."},
      {"The scan has 3 time steps; scan.time chooses one, 0.5 mm.",
       "The scan has 3 time steps; scan.time chooses one, 0.5 mm."}};
  for (const auto& [sentence, nameless] : cases) EXPECT_EQ(withoutNames(sentence, chosen), nameless);
}

TEST(Nameless, WhatIsCopiedFromTheLogHasNone) {
  MessageLog log;
  log.hide("/data/Anna Blume.nrrd");
  log.add(MessageLog::Kind::failure, "/data/Anna Blume.nrrd cannot be read; get a fresh copy.");
  EXPECT_NE(log.text().find(" error: [file] cannot be read; get a fresh copy.\n"), std::string::npos)
      << log.text();
  EXPECT_EQ(log.text().find("Blume"), std::string::npos);
}

}  // namespace
}  // namespace sonoskin::ui
