#include "core/io/dicom/dicom_volume.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <span>

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// Numbers of different meanings are not put side by side.
std::vector<DicomScale> scalesOf(const DicomVolume& volume, const fs::path& path) {
  std::vector<DicomScale> scales;
  bool given = false, lacking = false, changes = false;
  for (const DicomFrame& frame : volume.frames) {
    scales.push_back(frame.scale);
    given = given || frame.scale.given, lacking = lacking || !frame.scale.given;
    changes = changes || frame.scale.slope != 1 || frame.scale.intercept != 0;
  }
  require(!(given && lacking && changes),
          "The slices of the series in {} hold numbers of different types; export it as NRRD with 3D Slicer.",
          path.string());
  return scales;
}

// The pixels of all frames are alike but for the bits that are used.
NumberType typeOf(const DicomFiles& files, const DicomVolume& volume, const std::vector<DicomScale>& scales) {
  DicomPixels widest = files.files[std::size_t(volume.frames.front().file)].pixels;
  for (const DicomFrame& frame : volume.frames)
    widest.stored = std::max(widest.stored, files.files[std::size_t(frame.file)].pixels.stored);
  return scaledType(widest, scales);
}

// Slices may have a scale each, and with it a padding each; what is none holds no number.
std::vector<Padding> paddingsOf(const DicomFiles& files, std::span<const DicomFrame> frames) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  std::vector<Padding> paddings;
  bool any = false;
  for (const DicomFrame& frame : frames) {
    const auto padding = paddingOf(files.files[std::size_t(frame.file)].pixels, frame.scale);
    any = any || padding;
    paddings.push_back(padding.value_or(Padding{kNone, kNone}));
  }
  if (!any) paddings.clear();
  return paddings;
}

StoredVolume storedOf(const DicomFiles& files, const DicomVolume& volume, const fs::path& path) {
  StoredVolume stored;
  stored.format = volume.format;
  stored.geometry = volume.geometry;
  stored.spacingKnown = volume.spacingKnown;
  stored.type = typeOf(files, volume, scalesOf(volume, path));
  stored.components = files.files[std::size_t(volume.frames.front().file)].pixels.components();
  stored.timeSteps = volume.timeSteps, stored.stepSeconds = volume.stepSeconds;
  stored.beam = volume.beam;
  stored.modality = volume.modality;
  return stored;
}

std::uintmax_t bytesOf(const DicomFiles& files, const DicomVolume& volume) {
  std::vector<bool> counted(files.files.size());
  std::uintmax_t bytes = 0;
  for (const DicomFrame& frame : volume.frames) {
    const std::size_t file = std::size_t(frame.file);
    if (!counted[file]) bytes += files.files[file].bytes;
    counted[file] = true;
  }
  return bytes;
}

// A blank slice may be packed into next to nothing, but a scan is not blank as a whole.
void checkPacked(const DicomFiles& files, const DicomVolume& volume, const LoadedVolume& loaded,
                 const fs::path& path) {
  constexpr std::uintmax_t kSmall = 64u << 20, kMostPacked = 1032;
  const bool isPacked = files.files[std::size_t(volume.frames.front().file)].pixels.isPacked();
  const StoredVolume& s = loaded.stored;
  const std::uintmax_t bytes = s.geometry.voxels() * std::size_t(s.components) * numberTypeBytes(s.type);
  require(!isPacked || bytes <= kSmall || bytes / kMostPacked <= loaded.bytes,
          "{} declares far more pixels than it can hold; get a fresh copy.", path.string());
}

// Zero is black in ultrasound, and nothing was recorded there.
void blankOutside(const DicomRegion& region, const DicomFrame& frame, std::size_t pixelBytes,
                  std::uint8_t* out) {
  for (int j = 0; j < frame.size.y; ++j)
    for (int i = 0; i < frame.size.x; ++i) {
      const bool inside =
          i >= region.least.x && i <= region.most.x && j >= region.least.y && j <= region.most.y;
      const std::size_t pixel = std::size_t(j) * std::size_t(frame.size.x) + std::size_t(i);
      if (!inside) std::memset(out + pixel * pixelBytes, 0, pixelBytes);
    }
}

}  // namespace

std::optional<DicomRegion> commonRegion(const DicomFiles& files, const DicomVolume& volume) {
  std::optional<DicomRegion> common;
  for (const DicomFrame& frame : volume.frames) {
    const auto& own = files.files[std::size_t(frame.file)].region;
    if (own && common)
      common->least = glm::min(common->least, own->least), common->most = glm::max(common->most, own->most);
    else if (own)
      common = own;
  }
  return common;
}

LoadedVolume readDicomVolume(const DicomFiles& files, const DicomVolume& volume, const ReadOptions& options,
                             const Progress& progress, const fs::path& path) {
  LoadedVolume loaded;
  loaded.stored = storedOf(files, volume, path);
  loaded.bytes = bytesOf(files, volume);
  const std::size_t slices = volume.frames.size() / std::size_t(volume.timeSteps);
  const std::span<const DicomFrame> frames =
      std::span(volume.frames).subspan(slices * std::size_t(options.time - 1), slices);
  loaded.stored.padding = paddingsOf(files, frames);
  checkGeometry(loaded.stored, path);
  checkPacked(files, volume, loaded, path);
  const std::size_t bytes = loaded.stored.geometry.voxels() / slices * std::size_t(loaded.stored.components) *
                            numberTypeBytes(loaded.stored.type);
  loaded.numbers.resize(bytes * slices);
  const std::optional<DicomRegion> common = commonRegion(files, volume);
  std::optional<DicomSource> source;
  for (std::size_t s = 0, open = 0; s < slices; ++s) {
    progress.update(double(s) / double(slices));
    const DicomFrame& frame = frames[s];
    if (!source || open != std::size_t(frame.file)) {
      open = std::size_t(frame.file);
      source = files.files[open].open(path);
    }
    readFrame(*source, files.files[open].pixels, frame.index, frame.scale, loaded.stored.type,
              loaded.numbers.data() + s * bytes);
    if (const auto region = files.files[open].region ? files.files[open].region : common;
        options.regionOnly && region)
      blankOutside(*region, frame, bytes / (std::size_t(frame.size.x) * std::size_t(frame.size.y)),
                   loaded.numbers.data() + s * bytes);
  }
  return loaded;
}

}  // namespace sonoskin
