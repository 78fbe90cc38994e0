#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/number_type.h"
#include "core/io/padding.h"
#include "core/volume/sample_grid.h"
#include "core/volume/scan.h"

namespace sonoskin {

// StoredVolume: what the numbers that were read from a file or series mean.
struct StoredVolume {
  std::string format;  // for people: "NRRD"
  Geometry geometry;   // of the three axes of space
  bool spacingKnown = true;
  NumberType type = NumberType::uint8;
  int components = 1;                                  // numbers per voxel, side by side
  int timeSteps = 1;                                   // volumes of the same grid, one of which was read
  double stepSeconds = 0;                              // from one to the next; 0: the file does not tell
  std::optional<std::pair<double, double>> unitRange;  // values that mean 0 and 1, where the file tells
  std::vector<Padding>
      padding;  // numbers that mean nothing was recorded: of all, or of each slice; none: not told
  std::optional<Beam> beam;
  std::optional<SampleGrid> grid{};  // samples of a probe, not yet voxels: `geometry` has their number alone
  std::string
      modality{};  // DICOM's word for the machine: "US", "CT", ...; empty where the file does not tell
};

// LoadedVolume: a volume as it lies in its file or files, with the numbers in this machine's byte order.
struct LoadedVolume {
  StoredVolume stored;
  std::vector<std::uint8_t> numbers;  // of the time step that was asked for
  std::uintmax_t bytes = 0;           // of the file or files
  std::vector<std::uint8_t> mask{};   // not zero where voxels were recorded; empty: not told
};

// checkGeometry: refuses what cannot be a volume of three dimensions, and makes the direction exactly orthonormal.
//   errors   Error: fewer than 2 or more than 65535 voxels along an axis, more than 2^31 voxels; spacing, origin or
//            direction not finite, spacing not positive, sizes that no scan of a body has, axes not at right
//            angles; several numbers per voxel that are
//            no colour
void checkGeometry(StoredVolume& stored, const std::filesystem::path& path);

// checkTime: refuses a time step, counted from 1, that a file does not have.
void checkTime(int time, int timeSteps, const std::filesystem::path& path);

}  // namespace sonoskin
