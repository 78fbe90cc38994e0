// A session knows the name of the file that it has open, for the person at the screen: it stands in nothing that it writes, and
// in nothing that goes into a report.
#include <gtest/gtest.h>

#include "app/document/session.h"
#include "app/workspace/settings.h"
#include "core/base/log.h"
#include "core/io/file_formats.h"
#include "core/io/meshes/zip_file.h"
#include "core/io/volume_writer.h"
#include "core/phantom/phantom.h"
#include "tests/app/session_support.h"
#include "tests/support/temp_folder.h"

namespace sonoskin::test {
namespace {

namespace fs = std::filesystem;

void expectNameless(const std::string& text, const std::string& where) {
  for (const char* planted : {"Featherstone", "Wilhelmina", "19870605"})
    EXPECT_EQ(text.find(planted), std::string::npos) << planted << " in " << where;
}

// A scan with names in its header, its own name and its folder's.
fs::path namedScan(const TempFolder& folder) {
  const fs::path patient = folder / "Featherstone 19870605";
  fs::create_directory(patient);
  writeScan(patient / "a.nrrd", makePhantomScan(tinyPhantom().phantom));
  std::string bytes = fileText(patient / "a.nrrd");
  bytes.insert(bytes.find("\n\n"),
               "\n# Featherstone\ncontent: Wilhelmina\nPatientName:=Featherstone^Wilhelmina");
  return folder.write("Featherstone 19870605/Featherstone^Wilhelmina.nrrd", bytes);
}

TEST(PrivateSession, NothingItWritesOrLogsHoldsAName) {
  const TempFolder folder;
  const fs::path scan = namedScan(folder), out = folder / "out";
  fs::create_directory(out);
  const LogRecord record;
  Session session(tinySurface());
  session.openFile(scan);
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.hasScan());
  session.reconstruct();
  ASSERT_TRUE(wait(session));
  ASSERT_TRUE(session.results().mesh);
  session.erase(ballOnTheSurface(session));
  session.commitEdit();
  ASSERT_TRUE(wait(session));
  for (const std::string& ending : extensionsOf(FileKind::writtenMesh)) {
    session.saveMesh(out / ("surface_" + ending.substr(1) + ending));
    ASSERT_TRUE(wait(session)) << ending;
  }
  session.saveErased(out / "erased.nrrd");
  session.saveRecipe(out / "recipe.json");
  ASSERT_TRUE(wait(session));
  EXPECT_EQ(std::distance(fs::directory_iterator(out), {}),
            std::ptrdiff_t(2 * extensionsOf(FileKind::writtenMesh).size() + 2));
  for (const auto& entry : fs::directory_iterator(out)) {
    const std::string name = entry.path().filename().string();
    expectNameless(name, "a name");
    expectNameless(fileText(entry.path()), name);
    if (entry.path().extension() == ".3mf")
      expectNameless(ZipFile(entry.path()).part("3D/3DModel.model").value_or(""), name);
  }
  for (const LogLevel level : {LogLevel::info, LogLevel::warning})
    for (const std::string& sentence : record.sentences(level)) expectNameless(sentence, "the log");
  expectNameless(session.proposedName(".ply"), "the name that is proposed");
}

// The list of files that were opened is kept where the person lets it be kept, and nowhere else.
TEST(PrivateSession, TheRecentListIsEmptyWhereFilesAreNotRemembered) {
  Settings settings;
  settings.remembersFiles = false;
  settings.noteOpened("/home/a/Featherstone^Wilhelmina.nrrd");
  EXPECT_TRUE(settings.recent.empty());
}

}  // namespace
}  // namespace sonoskin::test
