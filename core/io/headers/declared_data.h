#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/io/headers/frame_poses.h"
#include "core/io/stored_volume.h"

// What the headers of NRRD, MetaImage, NIfTI and VTK legacy files say. They are read here and nowhere else:
// the place of every voxel, the unit of every length, which axis is time, and where the numbers lie. No other
// library has a say in it.
namespace sonoskin {

// Encoding: how the numbers are written. packed: zlib or gzip, told apart by the first bytes.
enum class Encoding { raw, packed, bzip2, text, hex };

// DataPart: a file, or a part of one, that holds numbers.
//   header  is what sentences name, as a name that stands in it may be a patient's
struct DataPart {
  std::filesystem::path file;
  std::uintmax_t offset = 0;  // where the data begin
  std::uintmax_t bytes = 0;   // of the packed data; 0: all that is left of the file
  std::filesystem::path header{};
};

// DeclaredData: what a header says.
//   stored      all that is known of the volume but its numbers; `type` is what they are after slope and
//               intercept
//   sizes       of all axes, fastest first; those that have no role below have one sample
//   spaceAxes   which of them are i, j, k
//   parts       one after another; each holds as many numbers as any other
struct DeclaredData {
  StoredVolume stored;
  std::vector<std::int64_t> sizes;
  std::array<int, 3> spaceAxes{0, 1, 2};
  int timeAxis = -1, componentAxis = -1;  // -1: there is none
  std::optional<FramePoses> poses;        // k is a row of flat pictures, each with a place of its own

  NumberType type = NumberType::uint8;  // in the file
  bool bigEndian = false;
  double slope = 1, intercept = 0;

  Encoding encoding = Encoding::raw;
  std::vector<DataPart> parts;
  std::int64_t linesSkipped = 0;    // at the beginning of each part, before unpacking
  std::uintmax_t bytesSkipped = 0;  // after them, and after unpacking
  bool lastBytes = false;           // the numbers are the last bytes of each part
};

// One function per format; they read the header only.
//   output  the geometry in mm and LPS, to be looked at by checkGeometry()
//   errors  Error: what in the header is contradictory, not safe, or not known here
// What a header leaves open and is assumed is logged as a warning.
DeclaredData nrrdData(const std::filesystem::path& path);   // teem.sourceforge.net/nrrd/format.html
DeclaredData metaData(const std::filesystem::path& path);   // itk.org/Wiki/ITK/MetaIO/Documentation
DeclaredData niftiData(const std::filesystem::path& path);  // nifti.nimh.nih.gov/nifti-1, nifti-2
DeclaredData vtkData(const std::filesystem::path& path);    // "VTK File Formats", simple legacy formats

// numbersIn: of all voxels, time steps and components.
//   errors  Error: sizes out of range, or more numbers than any memory holds
std::uint64_t numbersIn(const DeclaredData& data, const std::filesystem::path& path);

// setScale: what numbers mean: slope * number + intercept. Those that are not finite, and a slope of 0, say
// nothing.
//   output  data.slope, data.intercept; stored.type, a real one where they change anything
void setScale(DeclaredData& data, double slope, double intercept);

// takeKeys: the beam, the range and, of a row of pictures, the places that a header's own keys give.
//   errors  as posesFrom
void takeKeys(const HeaderKeys& keys, DeclaredData& data, const std::filesystem::path& path);

}  // namespace sonoskin
