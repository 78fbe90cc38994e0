#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

// A guard in front of ITK. Files come from strangers, and the header parsers of the ITK that Debian 12 ships trust
// them: dimension 16 of a NRRD overflows its stack (ITK issue 6575), a MetaImage of 93 bytes its heap (ITK 6853), and
// a compressed MetaImage that ends early is read in silence (ITK 6575, B66). So each header is looked at here first:
// just the fields that say how much there is and where, and whether their lists have as many numbers as ITK will take.
namespace sonoskin {

enum class Encoding { raw, packed, text };  // packed: zlib or gzip, told apart by its first bytes

// DeclaredData: what a header says about the voxels of a file.
struct DeclaredData {
  std::vector<std::int64_t> sizes;  // of all axes, fastest first
  std::int64_t components = 1;      // numbers per voxel that are not an axis of their own
  std::size_t bytesPerNumber = 1;
  bool spacingKnown = false;
  int timeAxis = -1;  // the axis of a NRRD that is a list of time steps, where one is

  std::filesystem::path file;      // the header's own or one beside it
  std::uintmax_t offset = 0;       // where the data begin in the file
  std::uintmax_t skipped = 0;      // bytes before the first number, within the packed data
  std::uintmax_t packedBytes = 0;  // of the packed data; 0: all that is left of the file
  Encoding encoding = Encoding::raw;
};

// One function per format; they read the header only.
//   errors   Error: what in the header is not safe, or not known here
DeclaredData nrrdData(const std::filesystem::path& path);
DeclaredData metaData(const std::filesystem::path& path);
DeclaredData niftiData(const std::filesystem::path& path);
DeclaredData vtkData(const std::filesystem::path& path);

// checkData: refuses a file that does not hold what its header declares. Takes no memory but for its output.
//   output  the numbers of a packed file of single bytes, which are as they are; nothing for others, which must be put in
//           order by who knows the format
//   errors   Error: sizes out of range, fewer bytes or numbers than declared, a packed stream that is damaged or does
//            not come to its end
//   cost     reads packed and text data once: 300 MB of voxels a second
std::vector<std::uint8_t> checkData(const DeclaredData& data, const std::filesystem::path& path);

// numbersIn: of all voxels, time steps and components. The data must have been checked.
std::uint64_t numbersIn(const DeclaredData& data);

// inflatedStart: the first `bytes` of a file, unpacked where it is packed; fewer where it ends early.
//   errors   as fileSize; Error: it cannot be read
std::vector<std::uint8_t> inflatedStart(const std::filesystem::path& path, std::size_t bytes);

}  // namespace sonoskin
