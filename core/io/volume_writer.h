#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/volume/scan.h"

namespace sonoskin {

// writeVolume: writes a volume in the format of the name's extension (FileKind::writtenVolume), atomically; packed, but
// for .vtk.
//   input   volume  intensities in [0, 1] as float, or any bytes
//           beam    kept by .nrrd and .mha, in keys of our own
//   errors  Error (usage): another extension, or a turned volume to .vtk, which cannot keep its direction;
//           (system) the file cannot be written; Cancelled
// .nrrd and .mha say that floats 0 and 1 mean 0 and 1, so that readScan gives back the same values.
void writeVolume(const std::filesystem::path& path, const Volume<float>& volume,
                 const std::optional<Beam>& beam = {}, const Progress& progress = {});
void writeVolume(const std::filesystem::path& path, const Volume<std::uint8_t>& volume,
                 const std::optional<Beam>& beam = {}, const Progress& progress = {});

// writeScan: writes a scan as bytes where it came from bytes (0..1 as 0..255), else as float.
//   errors  as writeVolume
void writeScan(const std::filesystem::path& path, const Scan& scan, const Progress& progress = {});

}  // namespace sonoskin
