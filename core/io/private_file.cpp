#include "core/io/private_file.h"

#include <fstream>

#include "core/base/error.h"
#include "core/io/atomic_file.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr fs::perms kMine = fs::perms::owner_read | fs::perms::owner_write;

}  // namespace

void writePrivately(const fs::path& file, const std::string& text) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  fs::permissions(file, kMine, error);  // an earlier file, whose permissions the new one takes over
  writeAtomically(file, [&](const fs::path& temporary) {
    fs::permissions(temporary, kMine);
    std::ofstream stream(temporary, std::ios::binary);
    stream << text;
    stream.close();
    require(bool(stream), "{} could not be written; check the room on the disk.", file.string());
  });
}

}  // namespace sonoskin
