#include "core/io/dicom_series.h"

#include <gdcmTrace.h>
#include <itkGDCMImageIO.h>
#include <itkGDCMSeriesFileNames.h>
#include <itkMetaDataObject.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "core/base/error.h"
#include "core/io/dicom_lengths.h"
#include "core/io/file_bytes.h"
#include "core/io/itk_files.h"

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
  for (const std::string& uid : Names(finder->GetSeriesUIDs())) {
    const Names names = finder->GetFileNames(uid);
    const bool holds = folder || std::any_of(names.begin(), names.end(), [&](const std::string& name) {
                         return fs::equivalent(name, path);
                       });
    if (holds && names.size() > largest.size()) largest = names;
  }
  if (largest.empty() && !folder) largest = {path.string()};
  require(!largest.empty(), "There is no DICOM series in the folder {}.", path.string());
  return largest;
}

// One file: its geometry and, when asked for, its pixels.
class Slice {
 public:
  explicit Slice(const fs::path& path) : path_(path), io_(itk::GDCMImageIO::New()) {
    checkDicomLengths(path);
    io_->SetFileName(path.string());
    guarded([&] { io_->ReadImageInformation(); });
    stored_ = describedBy(*io_, path);
    stored_.format = "DICOM series";
    stored_.modality = modality();
    stored_.spacingKnown = has("0028|0030") || has("0018|1164") || has("0018|2010");
  }

  const StoredVolume& stored() const { return stored_; }
  glm::dvec3 normal() const {
    return glm::cross(stored_.geometry.direction[0], stored_.geometry.direction[1]);
  }
  std::size_t bytes() const {
    return stored_.geometry.voxels() * std::size_t(stored_.components) * numberTypeBytes(stored_.type);
  }
  void read(std::uint8_t* out) {
    itk::ImageIORegion region(io_->GetNumberOfDimensions());
    for (unsigned a = 0; a < io_->GetNumberOfDimensions(); ++a) region.SetSize(a, io_->GetDimensions(a));
    io_->SetIORegion(region);
    require(std::size_t(io_->GetImageSizeInBytes()) == bytes(), "{} has a damaged header; get a fresh copy.",
            path_.string());
    guarded([&] { io_->Read(out); });
  }

 private:
  bool has(const char* tag) const {
    std::string ignored;
    return itk::ExposeMetaData(io_->GetMetaDataDictionary(), tag, ignored);
  }
  // Two capital letters by the standard; whatever else a file puts there is not passed on.
  std::string modality() const {
    std::string word;
    itk::ExposeMetaData(io_->GetMetaDataDictionary(), "0008|0060", word);
    word.erase(std::remove_if(word.begin(), word.end(), [](char c) { return c == ' ' || c == '\0'; }),
               word.end());
    const bool isCode =
        word.size() == 2 && std::ranges::all_of(word, [](char c) { return c >= 'A' && c <= 'Z'; });
    return isCode ? word : std::string();
  }
  // The libraries' own words may quote the file, so they are not passed on.
  template <class Call>
  void guarded(Call&& call) const {
    try {
      call();
    } catch (const std::exception&) {
      throw Error(
          fmt::format("{} holds no pixels that can be read; the copy is incomplete or of a kind that is not "
                      "known here.",
                      path_.string()));
    }
  }

  fs::path path_;
  itk::GDCMImageIO::Pointer io_;
  StoredVolume stored_;
};

// The distance between neighbours along the normal; refuses gaps, which would bend the face.
double sliceDistance(const std::vector<double>& along, const fs::path& path) {
  const double mean = (along.back() - along.front()) / double(along.size() - 1);
  for (std::size_t s = 1; s < along.size(); ++s)
    require(std::abs(along[s] - along[s - 1] - mean) <= 0.1 * std::abs(mean) && mean != 0,
            "The slices of the series in {} are not evenly spaced; some may be missing.", path.string());
  return mean;
}

// What the files together may unpack to; bounds the memory before it is taken.
void checkBytes(std::uintmax_t all, std::uintmax_t inFiles, const fs::path& path) {
  constexpr std::uintmax_t kMostPacked = 1032;
  require(all / kMostPacked <= inFiles, "{} declares far more pixels than it can hold; get a fresh copy.",
          path.string());
}

LoadedVolume readSlices(const Names& names, const fs::path& path, const Progress& progress) {
  Slice first(names.front());
  LoadedVolume series;
  series.stored = first.stored();
  Geometry& g = series.stored.geometry;
  require(g.dims.z == 1, "The series in {} has several volumes; choose one of its files.", path.string());
  g.dims.z = int(names.size());
  for (const std::string& name : names) series.bytes += fileSize(name);
  checkBytes(first.bytes() * names.size(), series.bytes, path);
  series.numbers.resize(first.bytes() * names.size());
  std::vector<double> along;
  for (std::size_t s = 0; s < names.size(); ++s) {
    progress.update(double(s) / double(names.size()));
    Slice slice(names[s]);
    const StoredVolume& one = slice.stored();
    require(one.geometry.dims == first.stored().geometry.dims && one.type == first.stored().type &&
                one.components == first.stored().components,
            "The slices of the series in {} differ in size; keep one series per folder.", path.string());
    slice.read(series.numbers.data() + s * first.bytes());
    along.push_back(glm::dot(one.geometry.origin, first.normal()));
  }
  const double distance = sliceDistance(along, path);
  g.spacing.z = std::abs(distance);
  g.direction[2] = first.normal() * (distance < 0 ? -1.0 : 1.0);
  return series;
}

LoadedVolume readFrames(const fs::path& path, const Progress& progress) {
  Slice file(path);
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

bool isDicom(const fs::path& path) {
  const std::vector<std::uint8_t> bytes = readBytes(path, 132);
  return bytes.size() == 132 && !std::memcmp(bytes.data() + 128, "DICM", 4);
}

LoadedVolume readDicomSeries(const fs::path& path, const Progress& progress) {
  silenceLibraries();
  if (!fs::is_directory(path)) {
    refuseMakersFormats(path);
    checkDicomLengths(path);
  }
  progress.update(0);
  const Names names = seriesFiles(path);
  if (names.size() == 1) refuseMakersFormats(names.front());
  return names.size() == 1 ? readFrames(names.front(), progress) : readSlices(names, path, progress);
}

}  // namespace sonoskin
