// Transfer functions in files, and the person's own ones.
#include "app/document/transfer_file.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "app/workspace/own_transfers.h"
#include "core/base/error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::TempFolder;

TEST(TransferFile, IsReadAsItWasWritten) {
  const TempFolder folder;
  const LevelledTransfer made{amberTransfer(0.31f), 0.31f};
  writeTransfer(folder / "new" / "a.json", made);
  const LevelledTransfer read = readTransfer(folder / "new" / "a.json");
  EXPECT_NEAR(read.level, 0.31, 1e-4);
  ASSERT_EQ(read.function.points.size(), made.function.points.size());
  for (float value = 0; value < 1; value += 0.01f)
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(read.function.at(value)[c], made.function.at(value)[c], 2e-3) << value;
}

TEST(TransferFile, RefusesWhatIsNone) {
  const TempFolder folder;
  const std::string point = R"({"value": 0.5, "opacity": 0.5, "colour": [1, 1, 1]})";
  for (const std::string& text :
       {std::string("{}"), std::string("[1]"), std::string("no json"),
        R"({"level": 0.3, "points": [)" + point + "]}",
        R"({"level": 2, "points": [)" + point + "," + point + "]}",
        R"({"level": 0.3, "points": [)" + point + R"(, {"value": 0.2, "opacity": 0, "colour": [1, 1, 1]}]})",
        R"({"level": 0.3, "points": [)" + point + R"(, {"value": 0.7, "opacity": 0, "colour": [1, 1]}]})"}) {
    folder.write("a.json", text);
    EXPECT_THROW(readTransfer(folder / "a.json"), Error) << text;
  }
  EXPECT_THROW(readTransfer(folder / "none.json"), Error);
}

TEST(TransferFile, ThePersonsOwnHaveNames) {
  const TempFolder folder;
  setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
  EXPECT_TRUE(ownTransfers().empty());
  keepTransfer("Very soft", {skinTransfer(0.4f), 0.4f});
  keepTransfer("Äther", {boneTransfer(0.4f), 0.4f});
  EXPECT_EQ(ownTransfers(), (std::vector<std::string>{"Very soft", "Äther"}));
  EXPECT_NEAR(ownTransfer("Very soft").level, 0.4, 1e-4);
  keepTransfer("Very soft", {skinTransfer(0.2f), 0.2f});
  EXPECT_NEAR(ownTransfer("Very soft").level, 0.2, 1e-4);
  for (const char* name : {"", "bone", "../up", "a/b", " x", ".hidden"})
    EXPECT_THROW(keepTransfer(name, {skinTransfer(0.2f), 0.2f}), Error) << name;
  forgetTransfer("Very soft");
  forgetTransfer("../settings");
  EXPECT_EQ(ownTransfers(), std::vector<std::string>{"Äther"});
}

}  // namespace
}  // namespace sonoskin
