#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace sonoskin {

// ZipFile: the parts of a file in ZIP's format, by minizip.  [APPNOTE 6.3]
//   errors  Error: it is none, or is cut off
class ZipFile {
 public:
  explicit ZipFile(const std::filesystem::path& path);

  // part: the unpacked bytes of a part, by its name without a slash in front, whatever its letters' case; nothing where
  // there is none.
  //   errors  Error: it is packed in a way that is not known, encrypted, damaged, or says that it unpacks to more than its
  //           bytes can (looked at before memory is taken for it)
  std::optional<std::string> part(const std::string& name) const;

 private:
  std::filesystem::path path_;
  std::uintmax_t size_;
  std::unique_ptr<void, int (*)(void*)> file_;
};

}  // namespace sonoskin
