// Names that files and folders have may be a patient's: none of them leaves with a result.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "app/workspace/settings.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/cli_support.h"

namespace sonoskin::test {
namespace {

namespace fs = std::filesystem;

// Of names that megabytes of numbers do not hold by chance.
struct Privacy : testing::Test {
  const TempFolder folder;
  const fs::path patient = folder / "Featherstone_Wilhelmina_1990-01-01";
  const fs::path scan = patient / "Featherstone^Wilhelmina.nrrd";

  void SetUp() override {
    fs::create_directory(patient);
    PhantomOptions phantom;
    phantom.dims = {117, 64, 31};
    writeScan(scan, makePhantomScan(phantom));
  }
  static void expectNameless(const std::string& text, const std::string& where) {
    for (const char* name : {"Featherstone", "Wilhelmina", "1990-01-01"})
      EXPECT_EQ(text.find(name), std::string::npos) << name << " in " << where;
  }
};

TEST_F(Privacy, NoResultHoldsANameOfFileOrFolder) {
  const fs::path out = patient / "out";
  const ProgramResult run =
      sonoskin({"run", scan.string(), "--out", out.string(), "--json", "--size", "64x64", "--mesh.resolution",
                "60", "--export", "ply,obj", "--keep", "classified,points"});
  ASSERT_EQ(run.status, 0) << run.err;
  expectNameless(run.out, "the result of run");
  for (const auto& entry : fs::directory_iterator(out)) {
    expectNameless(fileText(entry.path()), entry.path().filename().string());
    expectNameless(entry.path().filename().string(), "a name of a result");
  }
  const std::string mesh = (out / "mesh.ply").string(), picture = (patient / "Featherstone.png").string();
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"info", scan.string(), "--json"},
        {"info", mesh, "--json"},
        {"compare", mesh, mesh, "--json"},
        {"render", mesh, "--out", picture, "--size", "64x64", "--quality", "light", "--json"}}) {
    const ProgramResult result = sonoskin(words);
    ASSERT_EQ(result.status, 0) << result.err;
    const nlohmann::json json = nlohmann::json::parse(result.out);
    expectNameless(json.contains("input") ? json["input"].dump() : "", words[0]);
    if (words[0] != "render")
      expectNameless(result.out, words[0]);  // that names the file which was asked for
  }
}

TEST_F(Privacy, TheNameIsThereWhereItIsAskedFor) {
  const ProgramResult info = sonoskin({"info", scan.string(), "--json", "--name-input"});
  const nlohmann::json named = nlohmann::json::parse(info.out);
  EXPECT_EQ(named["file"], "Featherstone^Wilhelmina.nrrd");
  EXPECT_EQ(named["fingerprint"].get<std::string>().size(), 32u);
}

TEST_F(Privacy, SettingsAreForTheirUserAlone) {
  const fs::path file = folder / "config/settings.json";
  fs::create_directories(file.parent_path());
  fs::permissions(folder.write("config/settings.json", "{}"), fs::perms(0644));
  Settings settings;
  settings.noteOpened(scan);
  writeSettings(file, settings);
  struct stat facts;
  ASSERT_EQ(::stat(file.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600u);
  EXPECT_EQ(readSettings(file).recent.size(), 1u);
  settings.remembersFiles = false;
  settings.recent.clear();
  settings.noteOpened(scan);
  writeSettings(file, settings);
  EXPECT_FALSE(readSettings(file).remembersFiles);
  expectNameless(fileText(file), "settings that remember no files");
}

}  // namespace
}  // namespace sonoskin::test
