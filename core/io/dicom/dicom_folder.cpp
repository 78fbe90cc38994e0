#include "core/io/dicom/dicom_folder.h"

#include <algorithm>

#include "core/io/dicom/dicom_series.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Paths = std::vector<fs::path>;
constexpr std::size_t kMostFiles = 50'000;

void checkCount(std::size_t files, const fs::path& path) {
  require(files <= kMostFiles, "{} holds more than {} files; choose a folder with one study.", path.string(),
          kMostFiles);
}

bool isDirectoryFile(const fs::path& file) { return lowerCase(file.filename().string()) == "dicomdir"; }

bool isReadable(const fs::path& file) try { return isDicom(file); } catch (const Error&) {
  return false;
}

// In the order of their names, so that the same folder is always the same.
Paths filesIn(const fs::path& folder, const fs::path& path) {
  Paths files;
  std::error_code code, ignored;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
    if (!entry->is_regular_file(ignored) || isDirectoryFile(entry->path())) continue;
    files.push_back(entry->path());
    checkCount(files.size(), path);
  }
  require(!code, "The folder {} cannot be looked at; check its permissions.", path.string());
  std::ranges::sort(files);
  return files;
}

// The file that a directory's record names, part by part, below its folder; empty where it leads anywhere else.
fs::path named(std::string text, const fs::path& folder) {
  std::replace(text.begin(), text.end(), '\\', '/');
  const fs::path below(text);
  if (text.empty() || below.is_absolute()) return {};
  for (const fs::path& part : below)
    if (part == ".." || part == ".") return {};
  std::error_code code;
  // Copies under other systems often have small letters.
  for (const fs::path& file : {folder / below, folder / lowerCase(text)})
    if (fs::is_regular_file(file, code)) return file;
  return {};
}

// Nothing where it is damaged.
DicomDataSet readDirectory(const fs::path& directory, const fs::path& path) try {
  DicomSource source(directory, path);
  return readDataSet(source);
} catch (const Error&) {
  return {};
}

Paths filesOfDirectory(const fs::path& directory, const fs::path& path, DicomFiles& files) {
  const DicomDataSet set = readDirectory(directory, path);
  const fs::path folder = directory.has_parent_path() ? directory.parent_path() : fs::path(".");
  Paths found;
  std::size_t missing = 0;
  for (const DicomItem& record : set.root.items(tag::kDirectoryRecords)) {
    if (!record.find(tag::kReferencedFile)) continue;
    fs::path file = named(record.text(tag::kReferencedFile), folder);
    missing += file.empty();
    if (!file.empty()) found.push_back(std::move(file));
    checkCount(found.size(), path);
  }
  if (missing > 0 && !found.empty())
    files.warnings.push_back(fmt::format("{} of the files that the DICOMDIR names {} not there.", missing,
                                         missing > 1 ? "are" : "is"));
  return found;
}

// What lies beside a DICOMDIR that is of no use, as where the files of a disc were copied without their folders.
Paths besideDirectory(const fs::path& directory, const fs::path& path, DicomFiles& files) {
  Paths found = filesIn(directory.has_parent_path() ? directory.parent_path() : fs::path("."), path);
  std::erase_if(found, [](const fs::path& file) { return !isReadable(file); });
  require(!found.empty(), "{} names no files that are there; copy the folders beside it, too.",
          path.string());
  files.warnings.push_back(
      "The DICOMDIR is damaged, or names no files that are there; those beside it are taken.");
  return found;
}

Paths filesOf(const fs::path& path, const fs::path& list, DicomFiles& files) {
  if (list.empty()) return filesIn(path, path);
  Paths found = filesOfDirectory(list, path, files);
  return found.empty() ? besideDirectory(list, path, files) : found;
}

// Adds what can be read; gives the first reason why something cannot.
std::optional<Error> addAll(DicomCollector& collector, const Paths& names, const std::string& series,
                            DicomFiles& files, const Progress& progress) {
  std::optional<Error> first;
  std::size_t left = 0;
  for (std::size_t n = 0; n < names.size(); ++n) {
    progress.update(double(n) / double(names.size()));
    if (!isReadable(names[n])) continue;
    try {
      collector.add(names[n], series);
    } catch (const Error& error) {
      if (!first) first = error;
      ++left;
    }
  }
  if (left > 0)
    files.warnings.push_back(fmt::format("{} DICOM file{} left out: damaged, or without pictures.", left,
                                         left > 1 ? "s are" : " is"));
  return first;
}

bool isVolume(const DicomVolume& volume) { return volume.frames.empty() || volume.geometry.dims.z > 1; }

// Single pictures, such as scouts, are no volumes.
void leavePictures(DicomFiles& files) {
  if (std::ranges::none_of(files.volumes, isVolume)) return;
  std::size_t pictures = 0;
  for (const DicomVolume& volume : files.volumes)
    if (!isVolume(volume)) pictures += volume.frames.size();
  std::erase_if(files.volumes, [](const DicomVolume& volume) { return !isVolume(volume); });
  if (pictures > 0)
    files.warnings.push_back(fmt::format("{} picture{} left aside, as {} beside the volume.", pictures,
                                         pictures > 1 ? "s that are no slices are" : " that is no slice is",
                                         pictures > 1 ? "they lie" : "it lies"));
}

// What a chosen file is part of.
void keepChosen(DicomFiles& files) {
  std::erase_if(files.volumes, [](const DicomVolume& volume) {
    return volume.file != 0 &&
           std::ranges::none_of(volume.frames, [](const DicomFrame& f) { return f.file == 0; });
  });
}

void append(DicomFiles& files, DicomFiles more) {
  files.files = std::move(more.files), files.volumes = std::move(more.volumes);
  files.warnings.insert(files.warnings.end(), more.warnings.begin(), more.warnings.end());
}

}  // namespace

fs::path dicomDirectory(const fs::path& path) {
  std::error_code code;
  if (!fs::is_directory(path, code)) return isDirectoryFile(path) ? path : fs::path();
  for (const fs::path& file : {path / "DICOMDIR", path / "dicomdir"})
    if (fs::is_regular_file(file, code)) return file;
  return {};
}

DicomFiles dicomFiles(const fs::path& path, const Progress& progress) {
  const fs::path list = dicomDirectory(path);
  DicomCollector collector(path);
  DicomFiles files;
  if (list.empty() && !fs::is_directory(path)) {
    collector.add(path);
    const auto series = collector.lastSlice();
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (series && !series->empty()) {
      Paths others = filesIn(folder, path);
      std::erase_if(others, [&](const fs::path& other) { return other.filename() == path.filename(); });
      addAll(collector, others, *series, files, progress);
    }
    append(files, collector.finish());
    keepChosen(files);
    require(
        !files.volumes.empty(),
        "{} does not say where it lies among the slices of its series (Image Position); choose another one.",
        path.string());
    return files;
  }
  const Paths names = filesOf(path, list, files);
  const auto first = addAll(collector, names, {}, files, progress);
  append(files, collector.finish());
  if (files.volumes.empty() && first) throw *first;
  require(!files.volumes.empty(),
          "There is no DICOM series in the folder {}; choose the folder that holds its files.",
          path.string());
  leavePictures(files);
  return files;
}

}  // namespace sonoskin
