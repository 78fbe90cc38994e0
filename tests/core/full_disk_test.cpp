#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <csignal>
#include <functional>

#include "core/io/atomic_file.h"
#include "core/io/file_formats.h"
#include "core/io/image.h"
#include "core/io/mesh_writer.h"
#include "core/io/volume_writer.h"
#include "tests/support/expect_error.h"
#include "tests/support/solids.h"
#include "tests/support/temp_folder.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using test::fileText;
using test::TempFolder;

constexpr std::size_t kRoom = 20'000;  // bytes; every output below is larger

// Everything that the program writes, with what writes it. Noise does not shrink when it is packed.
const std::vector<std::pair<std::string, std::function<void(const fs::path&)>>>& outputs() {
  static const auto volume = [] {
    std::uint64_t n = 0;
    return test::fill(test::grid({40, 40, 40}), [&](glm::dvec3) { return test::noise(n++); });
  }();
  static const Volume<std::uint8_t> bytes = [] {
    Volume<std::uint8_t> v(volume.geometry);
    for (std::size_t i = 0; i < v.data.size(); ++i) v.data[i] = std::uint8_t(255 * volume.data[i]);
    return v;
  }();
  static const Mesh mesh = test::solid(
      [](const glm::dvec3& x) {
        return test::ball(x, {0, 0, 0}, 8);
      },
      {10, 10, 10}, 0.4);
  static const Image picture = [] {
    Image image;
    image.width = image.height = 200;
    for (std::uint64_t n = 0; n < 4 * 200 * 200; ++n)
      image.rgba.push_back(std::uint8_t(255 * test::noise(n)));
    return image;
  }();
  static std::vector<std::pair<std::string, std::function<void(const fs::path&)>>> all;
  if (all.empty()) {
    for (const std::string& extension : extensionsOf(FileKind::writtenVolume)) {
      all.emplace_back("float" + extension, [](const fs::path& p) { writeVolume(p, volume); });
      all.emplace_back("bytes" + extension, [](const fs::path& p) { writeVolume(p, bytes); });
    }
    for (const std::string& extension : extensionsOf(FileKind::writtenMesh))
      all.emplace_back("mesh" + extension, [](const fs::path& p) { writeMesh(p, mesh); });
    all.emplace_back("picture.png", [](const fs::path& p) { writePng(p, picture); });
    all.emplace_back("recipe.json", [](const fs::path& p) {
      const std::string text(2 * kRoom, ' ');
      writeBytes(p, text.data(), text.size());
    });
  }
  return all;
}

// Every output refuses, and leaves the earlier file as it was and nothing beside it.
void expectRefusals(const fs::path& folder) {
  for (const auto& [name, write] : outputs()) {
    SCOPED_TRACE(name);
    test::expectError([&, w = write] { w(folder / name); }, "", Error::Kind::system);
    EXPECT_EQ(fileText(folder / name), "old");
  }
  for (const auto& entry : fs::directory_iterator(folder))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
}

void putOldFiles(const fs::path& folder) {
  for (const auto& [name, write] : outputs()) std::ofstream(folder / name) << "old";
}

TEST(FullDisk, LeavesEarlierFilesAlone) {
  const TempFolder folder;
  if (::mount("none", folder.path().c_str(), "tmpfs", 0, "size=256k") != 0)
    GTEST_SKIP() << "a small file system cannot be mounted here";
  putOldFiles(folder.path());
  const std::string filling(std::size_t(fs::space(folder.path()).available) - kRoom, 'x');
  std::ofstream(folder / "filling") << filling;
  expectRefusals(folder.path());
  ::umount(folder.path().c_str());
}

// The same without a file system of its own: files may grow no further than the room.
TEST(FullDisk, SoDoFilesThatMayNotGrow) {
  const TempFolder folder;
  putOldFiles(folder.path());
  rlimit old, small;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  small = old;
  small.rlim_cur = kRoom;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  expectRefusals(folder.path());
  ::setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  for (const auto& [name, write] : outputs()) write(folder / name);  // with room all are written
}

}  // namespace
}  // namespace sonoskin
