#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

namespace sonoskin {

// DicomSource: the bytes of a file, read where they are wanted; of a deflated one those that it unpacks to.
class DicomSource {
 public:
  // file   the one that is read; named: the file or folder that a person gave, for sentences
  DicomSource(const std::filesystem::path& file, const std::filesystem::path& named);

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }
  // read: bytes from `offset` on.
  //   errors  Error: there are fewer
  void read(std::uint64_t offset, std::uint64_t length, std::uint8_t* out);
  std::vector<std::uint8_t> read(std::uint64_t offset, std::uint64_t length);
  // view: the same bytes without a copy, for as long as this is; those that nobody looks at stay on the disk.
  //   errors  as read; Error: the file cannot be mapped into memory
  std::span<const std::uint8_t> view(std::uint64_t offset, std::uint64_t length);
  // inflate: unpacks all from `offset` on, which stays where it is [DICOM PS3.5, A.5].
  //   errors  Error: it is damaged, or unpacks to more than 256 MB
  void inflate(std::uint64_t offset);

 private:
  void check(std::uint64_t offset, std::uint64_t length) const;
  void fill(std::uint64_t offset);
  void map();

  std::filesystem::path onDisk_, path_;  // the second one for sentences
  std::ifstream file_;
  std::uint64_t size_;
  std::uint64_t windowAt_ = 0;  // where the window begins
  std::vector<std::uint8_t> window_;
  std::uint64_t inflatedAt_ = 0;
  std::vector<std::uint8_t> inflated_;
  std::shared_ptr<const std::uint8_t> mapped_;
};

}  // namespace sonoskin
