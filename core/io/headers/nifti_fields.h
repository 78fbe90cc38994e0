#pragma once

#include <array>
#include <cstdint>
#include <filesystem>

namespace sonoskin {

// NiftiFields: the fields of a NIfTI-1 or NIfTI-2 header that say what its numbers mean, as the file has them
// [nifti1.h, nifti2.h].
struct NiftiFields {
  std::array<std::int64_t, 8> dim{};
  int datatype = 0;
  std::array<double, 8> pixdim{};
  std::int64_t offset = 0;  // of the voxels
  double slope = 0, intercept = 0;
  int units = 0;
  int qformCode = 0, sformCode = 0;
  std::array<double, 3> quaternion{}, qoffset{};
  std::array<std::array<double, 4>, 3> srow{};

  bool inTwoFiles = false;  // the voxels lie in a file beside it
  bool swapped = false;     // the other byte order than this machine's
};

// niftiFields: reads the header of a file, packed or not.
//   errors  Error: it is none; ANALYZE 7.5, which does not tell left from right
NiftiFields niftiFields(const std::filesystem::path& path);

}  // namespace sonoskin
