#include "core/io/dicom/dicom_series.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/dicom/dicom_folder.h"
#include "core/io/dicom/dicom_straighten.h"
#include "core/io/dicom/dicom_volume.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/scanners/kretz_file.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

bool isKretz(const DicomFiles& files, const DicomVolume& volume) {
  return files.files[std::size_t(volume.file)].kretz.second > 0;
}

LoadedVolume readKretz(const DicomFiles& files, const DicomVolume& volume, const ReadOptions& options,
                       const fs::path& path) {
  const DicomFile& file = files.files[std::size_t(volume.file)];
  DicomSource source = file.open(path);
  LoadedVolume loaded = kretzVolume(source.view(file.kretz.first, file.kretz.second), options, path);
  loaded.stored.format = "GE Kretz in DICOM";
  loaded.bytes = file.bytes;
  return loaded;
}

std::vector<VolumeEntry> entriesOf(const DicomFiles& files) {
  std::vector<VolumeEntry> entries;
  for (const DicomVolume& volume : files.volumes)
    entries.push_back({straightened(volume.geometry, volume.shift), volume.timeSteps, volume.modality});
  return entries;
}

// Where flow lies beside tissue, the tissue is what is meant, unless the options say another.
const DicomVolume& chosen(const DicomFiles& files, const ReadOptions& options, const fs::path& path) {
  const auto& volumes = files.volumes;
  require(options.volume <= int(volumes.size()), "{} holds {} volume{}; there is no volume {} (scan.volume).",
          path.string(), volumes.size(), volumes.size() > 1 ? "s" : "", options.volume);
  if (options.volume > 0) return volumes[std::size_t(options.volume) - 1];
  if (volumes.size() == 1) return volumes.front();
  if (std::ranges::count_if(volumes, &DicomVolume::isTissue) == 1) {
    log(LogLevel::info, fmt::format("The scan holds {} volumes: {}; that of tissue is used.", volumes.size(),
                                    entriesText(entriesOf(files))));
    return *std::ranges::find_if(volumes, &DicomVolume::isTissue);
  }
  throw Error(fmt::format("{} holds {} volumes: {}; choose one with scan.volume.", path.string(),
                          volumes.size(), entriesText(entriesOf(files))));
}

// What is burnt in, and whether it is blanked.
void sayOfRegions(const DicomFiles& files, const DicomVolume& volume, bool regionOnly) {
  const auto fileOf = [&](const DicomFrame& frame) -> const DicomFile& {
    return files.files[std::size_t(frame.file)];
  };
  const bool burned = std::ranges::any_of(volume.frames, &DicomFile::hasBurnedIn, fileOf);
  const auto silent =
      std::ranges::count_if(volume.frames, [&](const DicomFrame& frame) { return !fileOf(frame).region; });
  const bool told = silent < std::ssize(volume.frames);
  if (regionOnly && !told)
    log(LogLevel::warning,
        "The file does not say where in its frames the picture lies, so that nothing is blanked.");
  if (regionOnly && told && silent > 0)
    log(LogLevel::warning,
        fmt::format(
            "Where the picture lies in {} of {} frames is not told; they are blanked outside of where "
            "the others have it.",
            silent, volume.frames.size()));
  if (burned && !(regionOnly && told))
    log(LogLevel::warning,
        fmt::format("The file says that text is burnt into its pictures, which may name the patient; {}.",
                    told ? "scan.regionOnly blanks all outside of the picture itself"
                         : "look at the slices before you pass pictures on"));
}

void say(const DicomFiles& files, const DicomVolume& volume, bool regionOnly) {
  for (const std::string& warning : volume.warnings) log(LogLevel::warning, warning);
  if (volume.shift != glm::dvec2(0))
    log(LogLevel::warning,
        fmt::format("Each slice lies {:.4g} mm across the one before, as under a tilted gantry; they are put "
                    "onto a straight grid, with linear weights.",
                    glm::length(volume.shift)));
  sayOfRegions(files, volume, regionOnly);
}

}  // namespace

bool isDicom(const fs::path& path) { return beginsAs(FileFormat::dicom, readBytes(path, 132)); }

std::vector<VolumeEntry> dicomVolumes(const fs::path& path, const Progress& progress) {
  const DicomFiles files = dicomFiles(path, progress);
  if (files.volumes.size() > 1) return entriesOf(files);
  const DicomFile& file = files.files[std::size_t(files.volumes.front().file)];
  if (file.kretz.second == 0) return {};
  DicomSource source = file.open(path);
  return kretzVolumes(source.view(file.kretz.first, file.kretz.second), path);
}

LoadedVolume readDicomSeries(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  progress.update(0);
  const DicomFiles files = dicomFiles(path, progress.part(0, 0.3));
  for (const std::string& warning : files.warnings) log(LogLevel::warning, warning);
  const bool isAlone = files.volumes.size() == 1;
  if (isAlone && isKretz(files, files.volumes.front()))  // which may hold several itself
    return readKretz(files, files.volumes.front(), options, path);
  const DicomVolume& volume = chosen(files, options, path);
  if (volume.refusal) throw *volume.refusal;
  if (isKretz(files, volume)) {
    ReadOptions ofOne = options;
    ofOne.volume = 0;
    return readKretz(files, volume, ofOne, path);
  }
  checkTime(options.time, volume.timeSteps, path);
  say(files, volume, options.regionOnly);
  LoadedVolume loaded = readDicomVolume(files, volume, options, progress.part(0.3, 0.9), path);
  if (volume.shift != glm::dvec2(0)) straighten(loaded, volume.shift, progress.part(0.9, 1));
  return loaded;
}

}  // namespace sonoskin
