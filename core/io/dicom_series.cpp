#include "core/io/dicom_series.h"

#include <gdcmTrace.h>
#include <itkGDCMSeriesFileNames.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/dicom_lengths.h"
#include "core/io/dicom_slice.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Names = std::vector<std::string>;

// Their messages may quote elements of the file, and would go to the terminal.
void silenceLibraries() {
  itk::Object::GlobalWarningDisplayOff();
  gdcm::Trace::DebugOff();
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
}

// Files whose voxels only their maker's layout explains; ITK would give a wrong picture or none.
void refuseMakersFormats(const fs::path& path) {
  const std::vector<std::uint8_t> bytes = readBytes(path, 1u << 16);
  const std::string_view start(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  require(start.find("KRETZFILE") == std::string_view::npos,
          "{} holds a GE Kretz volume, which is not read yet; export it as NRRD with 3D Slicer.",
          path.string());
  require(start.find("1.2.840.113543.6.6.1.3.10002") == std::string_view::npos,
          "{} holds a Philips 3D volume, which is not read yet; export it as NRRD with 3D Slicer.",
          path.string());
}

// The files of the largest series in a folder, or of the one that `file` belongs to, in the order of their
// positions.
Names seriesFiles(const fs::path& path) {
  const bool folder = fs::is_directory(path);
  const auto finder = itk::GDCMSeriesFileNames::New();
  finder->SetUseSeriesDetails(true);
  finder->SetRecursive(false);
  const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
  finder->SetInputDirectory((folder ? path : parent).string());
  Names largest;
  int series = 0;
  for (const std::string& uid : Names(finder->GetSeriesUIDs())) {
    const Names names = finder->GetFileNames(uid);
    const bool holds = folder || std::any_of(names.begin(), names.end(), [&](const std::string& name) {
                         return fs::equivalent(name, path);
                       });
    series += holds;
    if (holds && names.size() > largest.size()) largest = names;
  }
  if (series > 1)
    log(LogLevel::info, fmt::format("The folder holds {} series; the largest, of {} slices, is used.", series,
                                    largest.size()));
  if (largest.empty() && !folder) largest = {path.string()};
  require(!largest.empty(),
          "There is no DICOM series in the folder {}; choose the folder that holds its files.",
          path.string());
  return largest;
}

// The distance between neighbours along the normal; refuses gaps, which would bend the face.
double sliceDistance(const std::vector<double>& along, const fs::path& path) {
  const double mean = (along.back() - along.front()) / double(along.size() - 1);
  for (std::size_t s = 1; s < along.size(); ++s)
    require(std::abs(along[s] - along[s - 1] - mean) <= 0.1 * std::abs(mean) && mean != 0,
            "The slices of the series in {} are not evenly spaced; some may be missing, get a complete copy.",
            path.string());
  return mean;
}

// What the files together may unpack to; bounds the memory before it is taken.
void checkBytes(std::uintmax_t all, std::uintmax_t inFiles, const fs::path& path) {
  constexpr std::uintmax_t kMostPacked = 1032;
  require(all / kMostPacked <= inFiles, "{} declares far more pixels than it can hold; get a fresh copy.",
          path.string());
}

// Slices may have a scale each, and with it a padding each; what is none holds no number.
void addPadding(StoredVolume& series, const StoredVolume& slice, std::size_t number) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  if (slice.padding.empty() && series.padding.empty()) return;
  series.padding.resize(number, Padding{kNone, kNone});
  series.padding.push_back(slice.padding.empty() ? Padding{kNone, kNone} : slice.padding.front());
}

LoadedVolume readSlices(const Names& names, const fs::path& path, const Progress& progress) {
  DicomSlice first(names.front());
  LoadedVolume series;
  series.stored = first.stored();
  Geometry& g = series.stored.geometry;
  require(g.dims.z == 1, "The series in {} has several volumes; choose one of its files.", path.string());
  g.dims.z = int(names.size());
  series.stored.padding.clear();
  for (const std::string& name : names) series.bytes += fileSize(name);
  checkBytes(first.bytes() * names.size(), series.bytes, path);
  series.numbers.resize(first.bytes() * names.size());
  std::vector<double> along;
  for (std::size_t s = 0; s < names.size(); ++s) {
    progress.update(double(s) / double(names.size()));
    DicomSlice slice(names[s]);
    const StoredVolume& one = slice.stored();
    require(one.geometry.dims == first.stored().geometry.dims && one.components == first.stored().components,
            "The slices of the series in {} differ in size; keep one series per folder.", path.string());
    require(
        one.type == first.stored().type,
        "The slices of the series in {} hold numbers of different types; export it as NRRD with 3D Slicer.",
        path.string());
    slice.read(series.numbers.data() + s * first.bytes());
    addPadding(series.stored, one, s);
    along.push_back(glm::dot(one.geometry.origin, first.normal()));
  }
  const double distance = sliceDistance(along, path);
  g.spacing.z = std::abs(distance);
  g.direction[2] = first.normal() * (distance < 0 ? -1.0 : 1.0);
  return series;
}

LoadedVolume readFrames(const fs::path& path, const Progress& progress) {
  DicomSlice file(path);
  LoadedVolume series;
  series.stored = file.stored();
  series.stored.format = "DICOM";
  // A distance of exactly 1 is what the library says when the file gives none.
  if (series.stored.geometry.spacing.z == 1) series.stored.spacingKnown = false;
  series.bytes = fileSize(path);
  checkBytes(file.bytes(), series.bytes, path);
  series.numbers.resize(file.bytes());
  progress.update(0.1);
  file.read(series.numbers.data());
  return series;
}

}  // namespace

bool isDicom(const fs::path& path) { return beginsAs(FileFormat::dicom, readBytes(path, 132)); }

// Of several series the largest is read.
std::vector<VolumeEntry> dicomVolumes(const fs::path&, const Progress&) { return {}; }

LoadedVolume readDicomSeries(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  silenceLibraries();
  if (!fs::is_directory(path)) {
    refuseMakersFormats(path);
    checkDicomLengths(path);
  }
  progress.update(0);
  const Names names = seriesFiles(path);
  if (names.size() == 1) refuseMakersFormats(names.front());
  LoadedVolume series =
      names.size() == 1 ? readFrames(names.front(), progress) : readSlices(names, path, progress);
  checkTime(options.time, series.stored.timeSteps, path);
  return series;
}

}  // namespace sonoskin
