// What headers say that is not read, and why; what they leave open.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/log.h"
#include "core/io/header_text.h"
#include "core/io/headers/units.h"
#include "core/io/volume_loader.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

using test::expectError;
using test::TempFolder;

const std::string k24(24, '\x80');

std::string nrrd(const std::string& more, const std::string& data = k24, const std::string& type = "uint8") {
  return "NRRD0005\ntype: " + type + "\ndimension: 3\nsizes: 2 3 4\nencoding: raw\n" + more + "\n" + data;
}
std::string mha(const std::string& more, const std::string& data = k24) {
  return "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementType = MET_UCHAR\nElementSpacing = 1 1 1\n" +
         more + "ElementDataFile = LOCAL\n" + data;
}
std::string vtk(const std::string& rest) {
  return "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 3 4\n" + rest;
}

// A NIfTI-1 of 2 x 3 x 4 bytes whose fields are set by hand.
class Nifti {
 public:
  Nifti() : bytes_(352, '\0') {
    set<std::int32_t>(0, 348);
    for (const auto& [n, v] : {std::pair(0, 3), {1, 2}, {2, 3}, {3, 4}, {4, 1}})
      set(40 + 2 * std::size_t(n), std::int16_t(v));
    set<std::int16_t>(70, 2), set<std::int16_t>(72, 8);
    for (std::size_t n = 0; n < 4; ++n) set(76 + 4 * n, 1.0f);
    set(108, 352.0f);
    bytes_[123] = 2;
    set<std::int16_t>(252, 1);
    bytes_.replace(344, 3, "n+1");
  }
  template <class T>
  Nifti& set(std::size_t at, T value) {
    std::memcpy(bytes_.data() + at, &value, sizeof value);
    return *this;
  }
  // matrix: the sform, by rows.
  Nifti& matrix(const std::array<float, 12>& rows) {
    set<std::int16_t>(254, 1);
    for (std::size_t n = 0; n < 12; ++n) set(280 + 4 * n, rows[n]);
    return *this;
  }
  std::string text() const { return bytes_ + k24; }

 private:
  std::string bytes_;
};

TEST(VolumeHeader, UnitsAreKnownInManyWords) {
  for (const auto& [word, mm] : {std::pair("mm", 1.0),
                                 {"CM", 10.0},
                                 {"metres", 1000.0},
                                 {"m", 1000.0},
                                 {"um", 1e-3},
                                 {"\xc2\xb5m", 1e-3},
                                 {"\xce\xbcm", 1e-3},
                                 {"\xb5m", 1e-3},
                                 {"Microns", 1e-3},
                                 {"inches", 25.4},
                                 {"in", 25.4},
                                 {" mm ", 1.0}})
    EXPECT_EQ(millimetresIn(word), mm) << word;
  EXPECT_FALSE(millimetresIn("pixel"));
  EXPECT_FALSE(millimetresIn("s"));
  EXPECT_EQ(secondsIn("ms"), 1e-3);
  EXPECT_EQ(secondsIn("seconds"), 1.0);
  EXPECT_FALSE(secondsIn("mm"));
}

TEST(VolumeHeader, NrrdIsRefusedWithItsReason) {
  const TempFolder folder;
  const auto refuses = [&](const std::string& more, const std::string& part,
                           const std::string& type = "uint8") {
    SCOPED_TRACE(more);
    expectError(
        [&] {
          loadVolume(
              folder.write("a.nrrd",
                           nrrd(more, std::string(more.starts_with("data file") ? 0 : 400, '\1'), type)),
              {});
        },
        part);
  };
  const std::string straight = "space directions: (1,0,0) (0,1,0) (0,0,1)\n";
  refuses("space: left-inferior-superior\n" + straight, "which NRRD does not have");
  refuses("space: LPS\nspace dimension: 2\n" + straight, "contradict each other");
  refuses("space dimension: 4\n" + straight, "three dimensions");
  refuses("space: LPS\nspace directions: (1,0,0) (0.5,1,0) (0,0,1)\n", "right angles");
  refuses("space: LPS\nspace directions: (1,0,0) (0,1,0)\n", "not 3 vectors");
  refuses("space: LPS\nspace directions: (1,0) (0,1) (1,1)\n", "not vectors of 3 numbers");
  refuses("space: LPS\nspace directions: (1,0,0) (0,nan,0) (0,0,1)\n", "not finite");
  refuses("space: LPS\nspace directions: (1,0,0) (0,0,0) (0,0,1)\n", "without length");
  refuses("space: LPS\n" + straight + "space origin: (1,2)\n", "not 3 numbers");
  refuses("space: LPS\n" + straight + "space units: \"mm\" \"mm\"\n", "not 3 words");
  refuses("spacings: 1 2\n", "one number per axis");
  refuses("spacings: 1 0 1\n", "must be positive");
  refuses("spacings: 1 1 1\naxis mins: 0 0 0\naxis maxs: 2 9 4\ncenters: cell cell cell\n", "contradict");
  refuses("kinds: domain domain vector\n", "2 of them of space");
  refuses("kinds: domain domain\n", "one word per axis");
  refuses("byte skip: -2\n", "byte skip");
  refuses("line skip: -1\n", "line skip");
  refuses("data file: LIST\n", "names no data files");
  refuses("data file: LIST\na.raw\nb.raw\n", "2 data files where 4 are needed");
  refuses("data file: a%d.raw 1 70000 1\n", "more than 65535 data files");
  refuses("data file: a%s.raw 1 4 1\n", "pattern that is not known");
  refuses("data file: ../a%d.raw 1 4 1\n", "outside of its own folder");
  refuses("", "endian", "int16");
}

TEST(VolumeHeader, NrrdPackedInWaysThatAreDamagedOrUnknown) {
  const TempFolder folder;
  const auto packed = [&](const std::string& how, const std::string& data) {
    std::string text = nrrd("", data);
    text.replace(text.find("raw"), 3, how);
    return [&folder, text] { loadVolume(folder.write("a.nrrd", text), {}); };
  };
  expectError(packed("zrl", k24), "an encoding that is not known here");
  expectError(packed("bzip2", "BZh9 and no more than this"), "damaged");
  expectError(packed("bzip2", "BZh9"), "ends before");
  expectError(packed("hex", "00 11 22"), "ends before");
  expectError(packed("hex", std::string(47, '0') + "x"), "not all numbers");
  expectError(packed("ascii", "1 2 3"), "ends before");
  std::string words;
  for (int n = 0; n < 24; ++n) words += n == 20 ? "300 " : "7 ";
  expectError(packed("ascii", words), "not all numbers");
}

TEST(VolumeHeader, MetaImageIsRefusedWithItsReason) {
  const TempFolder folder;
  const auto refuses = [&](const std::string& more, const std::string& part) {
    SCOPED_TRACE(more);
    expectError([&] { loadVolume(folder.write("a.mha", mha(more)), {}); }, part);
  };
  refuses("Offset = 1 2 3\nPosition = 1 2 4\n", "origin twice");
  refuses("TransformMatrix = 1 0 0 0 1 0 0 0 1\nRotation = -1 0 0 0 -1 0 0 0 1\n",
          "direction of the axes twice");
  refuses("TransformMatrix = 1 0 0 0 1 0 0 0\n", "9 finite numbers");
  refuses("TransformMatrix = 1 0 0 0 1 0 0 0.5 1\n", "right angles");
  refuses("ElementNumberOfChannels = 2\n", "ElementNumberOfChannels");
  refuses("Kinds = domain domain\n", "3 words");
  refuses("HeaderSize = -1\nCompressedData = True\n", "HeaderSize");
  refuses("A : b = 1\n", "a key in line 6 that programs read in different ways");
  refuses("Kinds = RGB-color domain domain\nElementNumberOfChannels = 3\n", "colours both as");
  std::string list = mha("", "a.raw\nb.raw\n");
  list.replace(list.find("LOCAL"), 5, "LIST");
  expectError([&] { loadVolume(folder.write("a.mhd", list), {}); }, "2 data files where 4 are needed");
}

// A header's own words may be a patient's name: a refusal names the field or the line.
TEST(VolumeHeader, RefusalsRepeatNoWordOfTheFile) {
  const TempFolder folder;
  const std::string who = "Featherstone";
  const auto refuses = [&](const std::string& name, const std::string& text, const std::string& part) {
    SCOPED_TRACE(text.substr(0, 300));
    try {
      loadVolume(folder.write(name, text), {});
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      const std::string sentence = lowerCase(error.what());
      EXPECT_EQ(sentence.find("featherstone"), std::string::npos) << sentence;
      EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
    }
  };
  const auto with = [&](std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
  };
  refuses("a.mha", mha(who + ": a = 1\n"), "line 6");
  refuses("a.mha", mha(who + " = 1\n" + who + " = 2\n"), "line 7");
  refuses("a.mha", with(mha(""), "MET_UCHAR", who), "elementtype");
  refuses("a.mha", mha("ElementNumberOfChannels = " + who + "\n"), "elementnumberofchannels");
  refuses("a.mha", mha("TransformMatrix = " + who + "\n"), "9 finite numbers");
  refuses("a.mhd", with(mha(""), "LOCAL", who + ".raw"), "not beside it");
  refuses(
      "a.mhd",
      with(mha("", who + "0.raw\n" + who + "1.raw\n" + who + "2.raw\n" + who + "3.raw\n"), "LOCAL", "LIST"),
      "not beside it");
  refuses("a.nrrd", nrrd(who + ": 1\n" + who + ": 1\n"), "line 7");
  refuses("a.nrrd", with(nrrd(""), "raw", who), "encoding");
  refuses("a.nrrd", nrrd("byte skip: " + who + "\n"), "byte skip");
  refuses("a.nrrd", nrrd("", k24, who), "type");
  refuses("a.nrrd", nrrd("space: " + who + "\n"), "space");
  refuses("a.nhdr", nrrd("data file: LIST " + who + "\n" + who + ".raw\n"), "dimensions");
  refuses("a.nhdr", nrrd("data file: " + who + ".raw\n"), "not beside it");
  refuses("a.vtk", vtk(who + " 1\nPOINT_DATA 24\n"), "a line before its point_data");
  refuses("a.vtk", vtk("POINT_DATA 24\n" + who + "\n"), "a line behind its point_data");
  refuses("a.vtk", vtk("POINT_DATA 24\n" + who + " a b c\n"), "a line behind its point_data");
  refuses("a.vtk", vtk("POINT_DATA 24\nSCALARS a " + who + "\n"), "type");
  refuses("a.dat", "ObjectFileName: " + who + ".raw\nResolution: 4 3 2\nFormat: UCHAR\n", "not beside it");
  refuses("a.dat", "ObjectFileName: a.raw\nResolution: 4 3 2\nFormat: " + who + "\n", "");
}

// What is wrong with a data file that is there, in every way to pack it.
TEST(VolumeHeader, DataFilesAreSpokenOfByTheirHeader) {
  const TempFolder folder;
  for (const auto& [encoding, bytes] : {std::pair<std::string, std::string>{"raw", "\x80"},
                                        {"gzip", "\x1f\x8b Featherstone"},
                                        {"bzip2", "BZh9Featherstone"},
                                        {"ascii", "1 2 3 Featherstone"},
                                        {"hex", std::string(48, 'z')},
                                        {"raw", ""}}) {
    folder.write("Featherstone.raw", bytes);
    for (const std::string skip : {"", "line skip: 3\n"}) {
      std::string text = nrrd(skip + "data file: Featherstone.raw\n");
      text.replace(text.find("raw"), 3, encoding);
      try {
        loadVolume(folder.write("a.nhdr", text), {});
        ADD_FAILURE() << "no error";
      } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()).find("Featherstone"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("a.nhdr"), std::string::npos) << error.what();
      }
    }
  }
}

// LIST is a word of its own, in large letters, as in Teem and MetaIO: a name may begin with it.
TEST(VolumeHeader, ADataFileMayBeCalledListSomething) {
  const TempFolder folder;
  std::string bytes;
  for (char c = 0; c < 24; ++c) bytes += c;
  for (const std::string name : {"list1.raw", "LISTING.raw", "listing", "list"}) {
    folder.write(name, bytes);
    std::string meta = mha("Offset = 1 2 3\n", "");
    meta.replace(meta.find("LOCAL"), 5, name);
    const LoadedVolume fromMeta = loadVolume(folder.write("a.mhd", meta), {});
    EXPECT_EQ(std::string(fromMeta.numbers.begin(), fromMeta.numbers.end()), bytes) << name;
    EXPECT_EQ(fromMeta.stored.geometry.origin, glm::dvec3(1, 2, 3)) << name;
    // Fields behind the name hold as well.
    const LoadedVolume fromNrrd = loadVolume(
        folder.write("a.nhdr",
                     "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 3 4\nencoding: raw\ndata file: " + name +
                         "\nspace: LPS\nspace directions: (2,0,0) (0,3,0) (0,0,4)\n"),
        {});
    EXPECT_EQ(std::string(fromNrrd.numbers.begin(), fromNrrd.numbers.end()), bytes) << name;
    EXPECT_EQ(fromNrrd.stored.geometry.spacing, glm::dvec3(2, 3, 4)) << name;
  }
}

// Of two places the matrix holds; what the other one says cannot make it worse.
TEST(VolumeHeader, ADamagedQuaternionDoesNotMatterWhereTheMatrixHolds) {
  const TempFolder folder;
  for (const auto& [b, offset] : {std::pair(0.9f, 0.f), {NAN, 0.f}, {1e35f, 0.f}, {0.f, INFINITY}}) {
    const Nifti nifti =
        Nifti().matrix({2, 0, 0, 5, 0, 2, 0, 6, 0, 0, 2, 7}).set(256, b).set(260, 0.9f).set(268, offset);
    const LogRecord said;
    const LoadedVolume loaded = loadVolume(folder.write("a.nii", nifti.text()), {});
    EXPECT_EQ(loaded.stored.geometry.origin, glm::dvec3(-5, -6, 7));
    EXPECT_EQ(loaded.stored.geometry.spacing, glm::dvec3(2));
    const auto warnings = said.sentences(LogLevel::warning);
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const auto& s) {
      return s.find("makes no sense; the first") != std::string::npos;
    }));
  }
}

// 0 is what some writers leave there.  [nifti1.h: the voxels of one file begin at byte 352 or later]
TEST(VolumeHeader, NiftiWithoutAnOffsetBeginsWhereTheStandardHasIt) {
  const TempFolder folder;
  const LogRecord said;
  const LoadedVolume loaded = loadVolume(folder.write("a.nii", Nifti().set(108, 0.f).text()), {});
  EXPECT_EQ(std::string(loaded.numbers.begin(), loaded.numbers.end()), k24);
  const auto warnings = said.sentences(LogLevel::warning);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                          [](const auto& s) { return s.find("at byte 352") != std::string::npos; }));
}

// Point 2 of what was found: these were all said to hold no voxels.
TEST(VolumeHeader, NiftiIsRefusedWithItsReason) {
  const TempFolder folder;
  const auto refuses = [&](const Nifti& nifti, const std::string& part) {
    expectError([&] { loadVolume(folder.write("a.nii", nifti.text()), {}); }, part);
  };
  refuses(Nifti().matrix({-1, 0.3f, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0}), "right angles");
  refuses(Nifti().matrix({-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0}), "without length");
  refuses(Nifti().set(256, 0.9f).set(260, 0.9f), "no rotation");
  refuses(Nifti().set<std::int16_t>(70, 32), "type 32");
  refuses(Nifti().set(344, '\0'), "does not tell left from right");
  refuses(Nifti().set<std::int16_t>(50, 3).set<std::int16_t>(40, 5), "more than one number per voxel");
  std::string pair = Nifti().set(345, 'i').text();
  pair.replace(344, 3, "ni1");
  expectError([&] { loadVolume(folder.write("a.hdr", pair), {}); }, "put the .img file beside it");
}

TEST(VolumeHeader, VtkIsRefusedWithItsReason) {
  const TempFolder folder;
  const auto refuses = [&](const std::string& text, const std::string& part) {
    expectError([&] { loadVolume(folder.write("a.vtk", text), {}); }, part);
  };
  refuses(vtk("POINT_DATA 24\nVECTORS v unsigned_char\n" + std::string(72, 'a')),
          "no grey or coloured numbers");
  refuses(vtk("POINT_DATA 23\nSCALARS s unsigned_char\nLOOKUP_TABLE default\n" + k24),
          "does not fit its DIMENSIONS");
  refuses(vtk("POINT_DATA 24\nSCALARS s bit\nLOOKUP_TABLE default\n" + k24), "type that is not known");
  refuses(vtk("POINT_DATA 24\nSCALARS s short\nLOOKUP_TABLE default\n" + k24), "ends before");
  std::string grid = vtk("");
  grid.replace(grid.find("STRUCTURED_POINTS"), 17, "STRUCTURED_GRID");
  refuses(grid, "regular grid");
  grid.replace(grid.find("STRUCTURED_GRID"), 15, "RECTILINEAR_GRID");
  refuses(
      grid + "X_COORDINATES 2 char\n" + std::string{0, 1} + "\nY_COORDINATES 3 char\n" + std::string{0, 1, 5},
      "not evenly spaced");
}

}  // namespace
}  // namespace sonoskin
