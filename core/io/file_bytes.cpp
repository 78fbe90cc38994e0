#include "core/io/file_bytes.h"

#include <algorithm>
#include <fstream>

#include "core/base/error.h"

namespace sonoskin {
namespace fs = std::filesystem;

std::uintmax_t fileSize(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  require(fs::exists(status), "There is no file {}; check the name.", path.string());
  require(fs::is_regular_file(status), "{} is not an ordinary file.", path.string());
  const std::uintmax_t size = fs::file_size(path, code);
  require(!code && size > 0, "The file {} is empty; get a fresh copy.", path.string());
  return size;
}

std::vector<std::uint8_t> readBytes(const fs::path& path, std::uintmax_t most) {
  std::vector<std::uint8_t> bytes(std::size_t(std::min(fileSize(path), most)));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
  require(bool(file), "The file {} cannot be read; check its permissions.", path.string());
  return bytes;
}

std::string readText(const fs::path& path, std::uintmax_t most) {
  require(fileSize(path) <= most, "{} is too large to be what it should be.", path.string());
  const std::vector<std::uint8_t> bytes = readBytes(path);
  return {bytes.begin(), bytes.end()};
}

std::string lowerExtension(const fs::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 'a' - 'A') : c; });
  if (name.ends_with(".nii.gz")) return ".nii.gz";
  return fs::path(name).extension().string();
}

}  // namespace sonoskin
