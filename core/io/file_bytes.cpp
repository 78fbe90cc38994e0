#include "core/io/file_bytes.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "core/base/error.h"

namespace sonoskin {
namespace fs = std::filesystem;

std::uintmax_t fileSize(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  require(code != std::errc::permission_denied && code != std::errc::operation_not_permitted,
          "{} cannot be looked at; check the permissions of its folder.", path.string());
  require(code != std::errc::too_many_symbolic_link_levels,
          "{} is a link that leads to itself; choose the file that it should lead to.", path.string());
  require(fs::exists(status), "There is no file {}; check the name.", path.string());
  require(!fs::is_directory(status), "{} is a folder, not a file; choose a file in it.", path.string());
  require(fs::is_regular_file(status), "{} is not an ordinary file; choose one that is.", path.string());
  const std::uintmax_t size = fs::file_size(path, code);
  require(!code && size > 0, "The file {} is empty; get a fresh copy.", path.string());
  return size;
}

std::vector<std::uint8_t> readBytes(const fs::path& path, std::uintmax_t most) {
  std::vector<std::uint8_t> bytes(std::size_t(std::min(fileSize(path), most)));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
  require(::faccessat(AT_FDCWD, path.c_str(), R_OK, AT_EACCESS) == 0,
          "The file {} may not be read; check its permissions.", path.string());
  require(bool(file), "The file {} cannot be read to its end; check the disk, or get a fresh copy.",
          path.string());
  return bytes;
}

std::string readText(const fs::path& path, std::uintmax_t most) {
  require(fileSize(path) <= most,
          "{} has more than {} MB, as no text that is read here has; choose another file.", path.string(),
          most >> 20);
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
