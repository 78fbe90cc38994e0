// Files that cannot be read: one line on standard error, exit status 3, nothing left behind.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/app/cli_support.h"

namespace sonoskin::test {
namespace {

struct BadFile {
  const char* name;
  std::string bytes;
};

std::string nrrd(const std::string& sizes, std::size_t bytes, const std::string& dimension = "3") {
  return "NRRD0004\ntype: uint8\ndimension: " + dimension + "\nsizes: " + sizes +
         "\nspacings: 1 1 1\nencoding: raw\nendian: little\n\n" + std::string(bytes, 'x');
}

std::vector<BadFile> badFiles() {
  return {{"empty.nrrd", ""},
          {"truncated.nrrd", nrrd("40 40 40", 1000)},
          {"no_data.nrrd", nrrd("40 40 40", 0)},
          {"two_dimensions.nrrd",
           "NRRD0004\ntype: uint8\ndimension: 2\nsizes: 40 40\nencoding: raw\n\n" + std::string(1600, 'x')},
          {"huge.nrrd", nrrd("60000 60000 60000", 1000)},
          {"overflow.nrrd", nrrd("4294967296 4294967296 4294967296", 1000)},
          {"negative.nrrd", nrrd("-40 40 40", 64000)},
          {"not_a_number.nrrd", nrrd("40 forty 40", 64000)},
          {"header_only.nrrd", "NRRD0004\n"},
          {"garbage.nrrd", std::string(4096, '\xff')},
          {"garbage.mha", std::string(4096, '\x01')},
          {"huge.mha",
           "ObjectType = Image\nNDims = 3\nDimSize = 99999 99999 99999\nElementType = MET_UCHAR\n"
           "ElementDataFile = LOCAL\n"},
          {"garbage.nii", std::string(4096, '\x02')},
          {"garbage.vtk", "# vtk DataFile Version 3.0\nnothing\nBINARY\nDATASET STRUCTURED_POINTS\n"},
          {"garbage.dcm", std::string(128, '\0') + "DICM" + std::string(100, '\xee')},
          {"letter.txt", "Dear Sir or Madam"}};
}

TEST(BadInput, EachGivesOneLineStatusThreeAndNothingElse) {
  for (const BadFile& bad : badFiles()) {
    SCOPED_TRACE(bad.name);
    const TempFolder folder;
    const std::string path = folder.write(bad.name, bad.bytes).string();
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"run", path, "--out", (folder / "out").string()},
          std::vector<std::string>{"info", path, "--json"},
          std::vector<std::string>{"render", path, "--out", (folder / "out.png").string()}}) {
      const ProgramResult result = sonoskin(arguments);
      EXPECT_EQ(result.status, 3) << arguments[0] << ": " << result.err;
      EXPECT_EQ(result.out, "");
      EXPECT_TRUE(result.err.starts_with("sonoskin: error: ")) << result.err;
      EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
      EXPECT_EQ(filesBelow(folder.path()), std::vector<std::string>{bad.name});
    }
  }
}

TEST(BadInput, AMissingFileIsNamed) {
  const ProgramResult result = sonoskin({"info", "/nowhere/scan.nrrd"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("/nowhere/scan.nrrd"), std::string::npos);
}

}  // namespace
}  // namespace sonoskin::test
