#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/io/read_options.h"
#include "core/io/volume_entry.h"
#include "core/volume/sample_grid.h"
#include "core/volume/scan.h"

namespace sonoskin {

// readScan: reads a recorded volume: NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), NIfTI (.nii, .nii.gz, .hdr), VTK legacy
// (.vtk), GE Kretz (.vol), Voreen (.dat, .vvd), Toshiba's export, numbers without a header, or DICOM (a folder, one of its
// files, a DICOMDIR).
//   output  intensities in [0, 1] (core/io/normalise.h tells how); world mm, LPS; of several time steps the one that the options name.
//           spacingKnown is false where the file gives none: the caller must say so
//   errors  Error: no such file, an unknown format, a file that is damaged, incomplete, flat or too large, each in one
//           sentence; Cancelled
//   cost    packed files 100 MB/s and more; six bytes of memory for one of an 8-bit file, all time steps
// Files are not trusted: every size is checked against the bytes that are there before memory is taken for
// it. Nothing that could name a patient is kept.
Scan readScan(const std::filesystem::path& path, const ReadOptions& options = {},
              const Progress& progress = {});

// listVolumes: what a file or folder with several volumes holds, in the order in which ReadOptions count them; empty where
// there is nothing to choose.
//   errors  as readScan, for what can be told without the voxels
std::vector<VolumeEntry> listVolumes(const std::filesystem::path& path, const ReadOptions& options = {},
                                     const Progress& progress = {});

// readMarks: the same of a volume that marks voxels, a mask or erased parts, whose sides may all be marked; the first time
// step of it.
//   raw     what one without a header is told to hold
//   errors  as readScan
Scan readMarks(const std::filesystem::path& path, const RawOptions& raw, const Progress& progress = {});

// VolumeInfo: what is in a volume file, for people. Holds nothing that could name a patient.
struct VolumeInfo {
  std::string format;        // "NRRD", "MetaImage", "NIfTI", "VTK", "DICOM series"
  Geometry geometry;         // of the time step that was read
  bool spacingKnown = true;  // false: the file gives none and 1 mm stands for it
  std::string numberType;    // "uint8", ...
  int components = 1;        // numbers per voxel
  int timeSteps = 1;
  double stepSeconds = 0;             // from one to the next; 0: the file does not tell
  double valueMin = 0, valueMax = 0;  // least and greatest finite value of that time step
  std::uintmax_t bytes = 0;           // of the file or files
  std::optional<Beam> beam;
  std::optional<SampleGrid>
      grid;  // of the samples that were converted to `geometry`; none: the file has voxels
  Key key;   // the fingerprint that a recipe of this volume holds (scanKey)
};

// readVolumeInfo: reads the file as readScan does and tells what is in it.
//   errors  as readScan
VolumeInfo readVolumeInfo(const std::filesystem::path& path, const ReadOptions& options = {},
                          const Progress& progress = {});

}  // namespace sonoskin
