#include "core/io/reader_process.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <limits>
#include <map>
#include <tuple>

#include "core/base/log.h"
#include "core/base/timer.h"
#include "core/io/file_formats.h"
#include "core/io/mesh_loader.h"
#include "core/io/mesh_reader.h"
#include "core/io/mesh_writer.h"
#include "core/io/reader_task.h"
#include "core/io/volume_loader.h"
#include "core/io/volume_reader.h"
#include "core/io/volume_writer.h"
#include "tests/support/dicom.h"
#include "tests/support/expect_error.h"
#include "tests/support/solids.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::expectError;
using test::fileText;
using test::TempFolder;

// Every test runs with readers; before it begins there are no threads that a fork could disturb.
struct Readers : testing::Test {
  Readers() { startReaders(); }
  const TempFolder folder;

  fs::path volume(const std::string& name) const {
    std::uint64_t n = 0;
    const auto noise =
        test::fill(test::grid({12, 9, 7}, {0.5, 0.6, 0.7}), [&](glm::dvec3) { return test::noise(n++); });
    writeVolume(folder / name, noise, Beam{glm::dvec3(1, 2, 3), {0, 1, 0}, {0, 0, 1}});
    return folder / name;
  }
  fs::path mesh(const std::string& name) const {
    writeMesh(folder / name, test::solid(
                                 [](const glm::dvec3& x) {
                                   return test::ball(x, {0, 0, 0}, 5);
                                 },
                                 {6, 6, 6}, 2));
    return folder / name;
  }
};

TEST_F(Readers, GiveTheSameVolume) {
  int withBeam = 0;
  for (const std::string& extension : extensionsOf(FileKind::writtenVolume)) {
    SCOPED_TRACE(extension);
    const fs::path file = volume("scan" + extension);
    const LoadedVolume here = loadVolume(file);
    const LoadedVolume apart = volumeFrom(readApart({ReaderTask::volume}, file).bytes(), file);
    EXPECT_EQ(apart.numbers, here.numbers);
    EXPECT_EQ(apart.bytes, here.bytes);
    EXPECT_EQ(apart.stored.format, here.stored.format);
    EXPECT_EQ(apart.stored.type, here.stored.type);
    EXPECT_EQ(apart.stored.geometry.spacing, here.stored.geometry.spacing);
    EXPECT_EQ(apart.stored.geometry.direction, here.stored.geometry.direction);
    EXPECT_EQ(apart.stored.unitRange, here.stored.unitRange);
    ASSERT_EQ(apart.stored.beam.has_value(), here.stored.beam.has_value());
    if (here.stored.beam) {
      EXPECT_EQ(apart.stored.beam->apex, here.stored.beam->apex);
      ++withBeam;
    }
  }
  EXPECT_GT(withBeam, 0);
}

TEST_F(Readers, GiveTheSameMesh) {
  for (const std::string& extension : extensionsOf(FileKind::writtenMesh)) {
    SCOPED_TRACE(extension);
    if (!formatNamed(FileKind::readMesh, "mesh" + extension)) continue;
    const fs::path file = mesh("mesh" + extension);
    const Mesh here = parseMesh(file), apart = readMesh(file);
    EXPECT_EQ(apart.positions, here.positions);
    EXPECT_EQ(apart.triangles, here.triangles);
    EXPECT_EQ(apart.normals, here.normals);
  }
}

// Links are how many archives keep their files.
TEST_F(Readers, FollowLinks) {
  fs::create_directory(folder / "links");
  fs::create_symlink(volume("scan.nrrd"), folder / "links/other.nrrd");
  fs::create_directory_symlink(folder / "links", folder / "way");
  EXPECT_EQ(readScan(folder / "links/other.nrrd").key, readScan(folder / "scan.nrrd").key);
  EXPECT_EQ(readScan(folder / "way/other.nrrd").key, readScan(folder / "scan.nrrd").key);
}

// A header that names a file elsewhere gets none of it.
TEST_F(Readers, SeeTheirFolderAlone) {
  const TempFolder elsewhere;
  elsewhere.write("secret.raw", std::string(8, 's'));
  for (const std::string& name : {(elsewhere / "secret.raw").string(), std::string("../secret.raw")}) {
    const fs::path header = folder.write(
        "a.nhdr",
        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: " + name + "\n");
    EXPECT_THROW(readApart({ReaderTask::volume}, header), Error);
  }
}

TEST_F(Readers, PassErrorsOn) {
  expectError([&] { readScan(folder / "missing.nrrd"); }, "There is no file");
  expectError([&] { readScan(folder.write("a.xyz", "x")); }, "known here");
  ASSERT_EQ(::mkfifo((folder / "pipe.nrrd").c_str(), 0600), 0);
  expectError([&] { readScan(folder / "pipe.nrrd"); }, "not an ordinary file");
  expectError([&] { readMesh(folder / "pipe.ply"); }, "There is no file");
}

// What ends the libraries: an assert of GDCM's, an overflow of teem's stack.
TEST_F(Readers, SurviveWhatTheLibrariesDoNot) {
  fs::create_directory(folder / "series");
  std::ofstream(folder / "series/a.dcm", std::ios::binary) << std::string(128, '\0') + "DICM";
  expectError([&] { readScan(folder / "series"); }, "");
  expectError([&] { readScan(folder / "series/a.dcm"); }, "");
  const std::string field = "space: " + std::string(3000, 'x') + "\n";
  const fs::path file = folder.write("long.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\n" + field +
                                                      "sizes: 2 2 2\nencoding: raw\n\n12345678");
  expectError([&] { readScan(file); }, "");
  EXPECT_NO_THROW(readScan(volume("good.nrrd")));  // the next file is read as ever
}

// Bytes that are damaged one by one, and files that end early: a result or a sentence, never the end.
TEST_F(Readers, SurviveDamagedFiles) {
  std::vector<fs::path> files;
  for (const std::string& extension : extensionsOf(FileKind::writtenMesh))
    if (formatNamed(FileKind::readMesh, "m" + extension)) files.push_back(mesh("m" + extension));
  for (const std::string& extension : extensionsOf(FileKind::writtenVolume))
    files.push_back(volume("v" + extension));
  std::uint64_t n = 7;
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.extension().string());
    const std::string whole = fileText(file);
    for (int damage = 0; damage < 24; ++damage) {
      std::string bytes = whole;
      if (damage < 4)
        bytes.resize(whole.size() * std::size_t(damage + 1) / 6);
      else
        bytes[std::size_t(test::noise(n++) * double(std::min<std::size_t>(whole.size(), 2000)))] ^=
            char(1 << damage % 8);
      const fs::path damaged = folder.write(fmt::format("d{}", file.filename().string()), bytes);
      try {
        if (file.stem() == "m")
          readMesh(damaged);
        else
          readScan(damaged);
      } catch (const Error& error) {
        EXPECT_TRUE(std::string(error.what()).ends_with('.')) << error.what();
      }
    }
  }
}

// The processes below this one that have none below themselves: those that read.
std::vector<pid_t> readers() {
  std::map<pid_t, pid_t> parents;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string stat = fileText(entry.path() / "stat");
    int parent = 0;
    const std::size_t after = stat.rfind(')');
    if (after != std::string::npos && std::sscanf(stat.c_str() + after, ") %*c %d", &parent) == 1)
      parents[pid_t(std::stoi(name))] = parent;
  }
  std::vector<pid_t> found;
  for (const auto& [process, parent] : parents) {
    const bool hasChild =
        std::ranges::any_of(parents, [&](const auto& other) { return other.second == process; });
    int depth = 0;
    for (pid_t at = process; at > 1 && at != ::getpid(); at = parents.contains(at) ? parents[at] : 0) ++depth;
    pid_t top = process;
    for (int d = 0; d < depth; ++d) top = parents.contains(top) ? parents[top] : 0;
    if (!hasChild && depth == 3 && top == ::getpid()) found.push_back(process);
  }
  return found;
}

// A reader that is ended from outside while it works: by what its limits send, by what a fault of a library sends, and by
// the system.
TEST_F(Readers, SayWhyTheyEnded) {
  std::uint64_t n = 0;
  const auto large = test::fill(test::grid({200, 200, 100}), [&](glm::dvec3) { return test::noise(n++); });
  writeVolume(folder / "large.nrrd", large);
  for (const auto& [signal, words, kind] :
       {std::tuple{SIGXCPU, "to read, which no file of its size needs", Error::Kind::input},
        {SIGSEGV, "broke down on it", Error::Kind::input},
        {SIGKILL, "The system ended the process", Error::Kind::system}}) {
    const int number = signal;
    ProgressSink sink;
    sink.report = [number](double) {
      for (const pid_t process : readers()) ::kill(process, number);
    };
    expectError([&] { readScan(folder / "large.nrrd", {}, Progress(sink)); }, words, kind);
  }
  EXPECT_NO_THROW(readScan(volume("good.nrrd")));
}

// What is said in the process that reads is heard in the program.
TEST_F(Readers, PassNotesOn) {
  for (int k = 0; k < 4; ++k) {
    test::DicomImage slice;
    slice.numbers.assign(12, 100 + k);
    slice.number = k + 1, slice.place = k;
    if (k == 3) slice.series += ".7", slice.number = 9;  // a picture of another series
    folder.write(fmt::format("{}.dcm", k), dicomFile(slice));
  }
  LogRecord record;
  EXPECT_EQ(readScan(folder.path()).volume->geometry.dims.z, 3);
  EXPECT_EQ(
      record.sentences(LogLevel::warning),
      std::vector<std::string>{"1 picture that is no slice is left aside, as it lies beside the volume."});
}

TEST_F(Readers, CanBeCancelled) {
  ProgressSink sink;
  sink.cancel = true;
  EXPECT_THROW(readScan(volume("scan.nrrd"), {}, Progress(sink)), Cancelled);
}

// Answers that contradict themselves are refused, whatever wrote them.
TEST(ReaderWire, TrustsNothing) {
  std::vector<std::uint8_t> bytes;
  const TempFolder folder;
  Mesh square;
  square.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  square.triangles = {{0, 1, 2}};
  writeMesh(folder / "a.ply", square);
  performTask({ReaderTask::mesh}, folder / "a.ply",
              [&](const void* data, std::size_t count) {
                const auto* from = static_cast<const std::uint8_t*>(data);
                bytes.insert(bytes.end(), from, from + count);
              },
              {});
  EXPECT_EQ(meshFrom(bytes, "a.ply").triangles, square.triangles);
  for (std::size_t end = 0; end < bytes.size(); ++end)
    expectError([&] { meshFrom(std::span(bytes).first(end), "a.ply"); }, "a.ply");
  for (std::size_t b = 0; b < bytes.size();
       ++b) {  // any byte may be wrong: an answer that holds, or a refusal
    std::vector<std::uint8_t> wrong = bytes;
    wrong[b] ^= 0x80;
    try {
      const Mesh mesh = meshFrom(wrong, "a.ply");
      for (const Triangle& t : mesh.triangles) EXPECT_LT(std::max({t[0], t[1], t[2]}), mesh.positions.size());
    } catch (const Error&) {
    }
  }
}

TEST(ReaderWire, RefusesMeshesThatBreakTheirPromises) {
  Mesh good;
  good.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  good.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  good.visibility = good.measured = {0, 0.5f, 1};
  good.triangles = {{0, 1, 2}};
  const auto passed = [](const Mesh& mesh) {
    std::vector<std::uint8_t> bytes;
    writeAnswer(mesh, [&](const void* data, std::size_t count) {
      const auto* from = static_cast<const std::uint8_t*>(data);
      bytes.insert(bytes.end(), from, from + count);
    });
    return meshFrom(bytes, "a.ply");
  };
  EXPECT_EQ(passed(good).normals, good.normals);
  Mesh normals = good, visibility = good, far = good;
  normals.normals[1].x = std::numeric_limits<float>::quiet_NaN();
  visibility.visibility[1] = -1;
  far.positions[1].x = 1e30f;
  for (const Mesh& wrong : {normals, visibility, far}) expectError([&] { passed(wrong); }, "a.ply");
}

}  // namespace
}  // namespace sonoskin
