#include "core/io/meshes/zip_file.h"

#include <minizip/unzip.h>

#include "core/base/error.h"
#include "core/io/file_bytes.h"

namespace sonoskin {
namespace {

constexpr std::uint64_t kMostGrowth = 1032;                   // of deflate, for each packed byte
constexpr std::uint64_t kMostBytes = std::uint64_t(8) << 30;  // of one part

}  // namespace

ZipFile::ZipFile(const std::filesystem::path& path)
    : path_(path), size_(fileSize(path)), file_(unzOpen64(path.c_str()), unzClose) {
  require(file_ != nullptr, "{} is damaged or incomplete: it is no whole ZIP file; get a fresh copy.",
          path.string());
}

std::optional<std::string> ZipFile::part(const std::string& name) const {
  constexpr int kAnyCase = 2;
  if (unzLocateFile(file_.get(), name.c_str(), kAnyCase) != UNZ_OK) return {};
  const auto check = [&](bool holds) {
    require(
        holds,
        "{} is damaged, incomplete, encrypted or packed in a way that is not known here; get a fresh copy.",
        path_.string());
  };
  unz_file_info64 facts{};
  check(unzGetCurrentFileInfo64(file_.get(), &facts, nullptr, 0, nullptr, 0, nullptr, 0) == UNZ_OK);
  const bool isPacked = facts.compression_method != 0;
  check((facts.flag & 1) == 0 && facts.compressed_size <= size_ && facts.uncompressed_size <= kMostBytes &&
        facts.uncompressed_size <= facts.compressed_size * (isPacked ? kMostGrowth : 1));
  check(unzOpenCurrentFile(file_.get()) == UNZ_OK);
  std::string bytes(facts.uncompressed_size, '\0');
  std::size_t at = 0;
  while (at < bytes.size()) {
    const int got = unzReadCurrentFile(file_.get(), bytes.data() + at,
                                       unsigned(std::min<std::size_t>(bytes.size() - at, 1u << 30)));
    if (got <= 0) break;
    at += std::size_t(got);
  }
  const bool isWhole = unzCloseCurrentFile(file_.get()) == UNZ_OK;  // its checksum is right
  check(isWhole && at == bytes.size());
  return bytes;
}

}  // namespace sonoskin
