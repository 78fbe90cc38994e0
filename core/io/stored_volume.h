#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/volume/scan.h"

namespace sonoskin {

// NumberType: how a file stores one number.
enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
std::string_view numberTypeName(NumberType type);  // "uint8", ...
std::size_t numberTypeBytes(NumberType type);

// Encoding: how the numbers lie in the file. `deflate` is zlib or gzip, told apart by its first bytes.
enum class Encoding { raw, deflate, text };

// StoredVolume: what the header of a volume file declares. The headers are parsed by our own strict code and
// not by a library: files come from strangers, and the header parsers of the ITK that Debian 12 ships have
// known memory errors (ITK issues 6575 and 6853, MetaIO issue 150) that a check beforehand would have to
// parse the header to find.
struct StoredVolume {
  std::string format;  // for people: "NRRD"
  Geometry geometry;   // of the three axes of space
  bool spacingKnown = true;
  NumberType type = NumberType::uint8;
  int components = 1;                                  // numbers per voxel, side by side
  int timeSteps = 1;                                   // volumes one after another, or
  bool timeIsFastest = false;                          // side by side, as components
  double slope = 1, intercept = 0;                     // value = slope * number + intercept
  std::optional<std::pair<double, double>> unitRange;  // values that mean 0 and 1, where the file tells
  std::optional<Beam> beam;

  std::filesystem::path dataFile;
  std::uintmax_t fileOffset = 0;    // where raw, text or packed data begin in the file
  std::uintmax_t streamOffset = 0;  // bytes of unpacked data before the first number
  Encoding encoding = Encoding::raw;
  bool bigEndian = false;
};

// The headers, one function per format; no voxels are read and no more memory taken than the header's size.
//   errors  Error: what is wrong with the file, in one sentence
StoredVolume readNrrdHeader(const std::filesystem::path& path);
StoredVolume readMetaHeader(const std::filesystem::path& path);
StoredVolume readNiftiHeader(const std::filesystem::path& path);
StoredVolume readVtkHeader(const std::filesystem::path& path);

// checkGeometry: refuses what cannot be a volume of three dimensions.
//   errors  Error: fewer than 2 or more than 65535 voxels along an axis, more than 2^31 voxels; spacing,
//   origin or
//           direction not finite, spacing not positive, axes not at right angles; several numbers per voxel
//           that are neither colour nor time
// The direction is made exactly orthonormal.
void checkGeometry(StoredVolume& stored, const std::filesystem::path& path);

// checkStored: checkGeometry, and refuses a file that has fewer bytes than its header declares.
void checkStored(StoredVolume& stored, const std::filesystem::path& path);

// readNumbers: the numbers of the first time step, in this machine's byte order.
//   input   stored  checked
//   output  voxels * components * bytes per number
//   errors  Error: the data end early or are damaged; Cancelled
std::vector<std::uint8_t> readNumbers(const StoredVolume& stored, const Progress& progress = {});

// inflateStart: the first `bytes` of what a zlib or gzip stream holds; fewer where it ends early.
std::vector<std::uint8_t> inflateStart(const std::filesystem::path& path, std::size_t bytes);

}  // namespace sonoskin
