#include "core/io/dicom/dicom_collector.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/io/dicom/dicom_makers.h"
#include "core/io/dicom/dicom_sweep.h"
#include "core/io/file_bytes.h"
#include "core/io/scanners/kretz_file.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// Two capital letters by the standard; whatever else a file puts there is not passed on.
std::string modalityOf(const DicomItem& root) {
  const std::string word = root.text(tag::kModality);
  const bool isCode =
      word.size() == 2 && std::ranges::all_of(word, [](char c) { return c >= 'A' && c <= 'Z'; });
  return isCode ? word : std::string();
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

// What a file is a copy by: its UID, which some programs give to all slices of a series, and what else tells slices apart.
std::string identityOf(const DicomItem& root) {
  const std::string instance = root.text(tag::kSopInstance);
  if (instance.empty()) return instance;
  std::string identity = instance + ' ' + root.text(tag::kSeries) + ' ' + root.text(tag::kImageType);
  for (const DicomTag tag :
       {tag::kInstance, tag::kPosition, tag::kOrientation, tag::kAcquisition, tag::kTemporal,
        tag::kTriggerTime, tag::kAcquisitionTime, tag::kContentTime, tag::kEchoTime, tag::kEchoNumber,
        tag::kDiffusionB, tag::kRows, tag::kColumns, tag::kFrames})
    identity += fmt::format(" {}", fmt::join(root.numbers(tag), ","));
  return identity;
}

}  // namespace

DicomSource DicomFile::open(const fs::path& named) const {
  DicomSource source(path, named);
  if (inflatedAt > 0) source.inflate(inflatedAt);
  return source;
}

void DicomCollector::add(const fs::path& file, const std::string& onlySeries) {
  DicomSource source(file, path_);
  const DicomDataSet set = readDataSet(source);
  const std::string series = set.root.text(tag::kSeries), identity = identityOf(set.root);
  if (!onlySeries.empty() && series != onlySeries) return;
  refuseOtherKinds(set.root, path_);
  if (!identity.empty() && identities_.contains(identity)) {
    ++copies_;
    return;
  }
  const std::size_t files = found_.files.size();
  DicomFile& added = found_.files.emplace_back();
  added.path = file, added.bytes = fileSize(file);
  added.inflatedAt = set.inflatedAt;
  added.hasBurnedIn = set.root.text(tag::kBurnedIn) == "YES";
  modalities_.resize(files), warnings_.resize(files);
  modalities_.push_back(modalityOf(set.root)), warnings_.emplace_back();
  try {
    addPictures(set, source);
  } catch (...) {
    found_.files.pop_back();
    throw;
  }
  identities_.insert(identity);
  lastSeries_ = series;
}

std::optional<std::string> DicomCollector::lastSlice() const {
  const bool isSlice = !slices_.empty() && slices_.back().file == int(found_.files.size()) - 1;
  return isSlice ? std::optional(lastSeries_) : std::nullopt;
}

void DicomCollector::addPictures(const DicomDataSet& set, DicomSource& source) {
  DicomFile& file = found_.files.back();
  const DicomElement* kretz = set.root.find(tag::kKretzFile);
  if (kretz && kretz->length > 0) {
    addKretz(*kretz, source);
    return;
  }
  auto own = makersPixels(set.root);
  file.pixels = own ? std::move(*own) : pixelsOf(set, source);
  DicomSpacing spacing = spacingOf(set.root);
  if (kretz)
    spacing.warnings.push_back(
        "The file has room for a Kretz file within it, but nothing is there; its pictures are read.");
  if (!own) file.region = spacing.region;  // which is of the pictures that own voxels are not
  warnings_.back() = spacing.warnings;
  if (auto makers = makersVolume(set.root, file.pixels, path_)) {
    push({std::move(*makers)});
    return;
  }
  auto frames = framesOf(set.root, file.pixels, spacing);
  for (DicomFrame& frame : frames) frame.file = int(found_.files.size()) - 1;
  if (frames.size() == 1)
    slices_.push_back(frames.front());
  else
    addFrames(set.root, std::move(frames), spacing);
}

// What no one can read is told now, so that it does not stand in the way of others.
void DicomCollector::addKretz(const DicomElement& element, DicomSource& source) {
  const VolumeEntry entry = kretzEntry(source.view(element.offset, element.length), path_);
  found_.files.back().kretz = {element.offset, element.length};
  DicomVolume volume;
  volume.geometry.dims = entry.dims, volume.timeSteps = entry.timeSteps;
  push({std::move(volume)});
}

void DicomCollector::addFrames(const DicomItem& root, std::vector<DicomFrame> frames,
                               const DicomSpacing& spacing) {
  const bool placed = hasFrameGroups(root) &&
                      std::ranges::any_of(frames, [](const DicomFrame& f) { return f.position.has_value(); });
  const DicomPixels& pixels = found_.files.back().pixels;
  std::vector<DicomVolume> volumes;
  if (placed)
    volumes = stacksOf(frames, path_);
  else
    volumes.push_back(sweepOf(root, std::move(frames), pixels, path_));
  for (DicomVolume& volume : volumes) {
    volume.beam = transducerBeam(root, volume.geometry);
    append(volume.warnings, spacing.warnings);
  }
  push(std::move(volumes));
}

void DicomCollector::push(std::vector<DicomVolume> volumes) {
  for (DicomVolume& volume : volumes) {
    volume.file = int(found_.files.size()) - 1;
    volume.modality = modalities_.back();
    for (DicomFrame& frame : volume.frames) frame.file = volume.file;
    found_.volumes.push_back(std::move(volume));
  }
}

DicomFiles DicomCollector::finish() {
  for (DicomVolume& volume : stacksOf(slices_, path_)) {
    const std::size_t file = std::size_t(volume.file);
    volume.format = "DICOM series", volume.modality = modalities_[file];
    append(volume.warnings, warnings_[file]);
    found_.volumes.push_back(std::move(volume));
  }
  std::ranges::stable_sort(found_.volumes, {}, &DicomVolume::file);
  if (copies_ > 0)
    found_.warnings.push_back(copies_ > 1 ? fmt::format("{} files are left out as copies of others.", copies_)
                                          : "A file is left out as a copy of another.");
  return std::move(found_);
}

}  // namespace sonoskin
