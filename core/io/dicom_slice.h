#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "core/io/stored_volume.h"

namespace sonoskin {

// DicomSlice: one file of DICOM: what its numbers mean and, when asked for, the numbers.
//   errors  Error: an element that is longer than the file; no pixels that can be read
class DicomSlice {
 public:
  explicit DicomSlice(const std::filesystem::path& path);
  ~DicomSlice();

  // stored: of its frames. Its padding is one range, after slope and intercept, where the file names one [DICOM PS3.3,
  // C.7.5.1.1.2].
  const StoredVolume& stored() const { return stored_; }
  glm::dvec3 normal() const;
  std::size_t bytes() const;
  // read: the numbers after slope and intercept, `bytes()` of them, as `stored().type`.
  //   errors  Error: the file holds another number of bytes than it declared, or the library cannot read it
  void read(std::uint8_t* out);

 private:
  struct Reader;  // of the library
  std::optional<std::string> text(const char* tag) const;
  std::optional<int> number(const char* tag) const;
  std::string modality() const;
  std::optional<Padding> padding() const;

  std::filesystem::path path_;
  std::unique_ptr<Reader> reader_;
  StoredVolume stored_;
};

}  // namespace sonoskin
