#include "core/io/dicom/dicom_makers.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kQlab = "1.2.840.113543.6.6.1.3.10002";
constexpr std::string_view kUltrasoundFrames = "1.2.840.10008.5.1.4.1.1.3.1";

// The frames of a file as slices of time steps, one after another.
DicomVolume inOrder(const DicomPixels& p, int slices, const glm::dvec3& spacing, std::string format) {
  DicomVolume volume;
  volume.format = std::move(format);
  volume.geometry.dims = {p.columns, p.rows, slices};
  volume.geometry.spacing = spacing;
  volume.timeSteps = p.frames / slices;
  volume.frames.resize(std::size_t(p.frames));
  for (int f = 0; f < p.frames; ++f) {
    DicomFrame& frame = volume.frames[std::size_t(f)];
    frame.index = f, frame.size = {p.columns, p.rows};
  }
  return volume;
}

void warnOfExtent(DicomVolume& volume) {
  constexpr double kMostPlausible = 600;  // mm; no probe sees as far
  const glm::dvec3 extent = volume.geometry.spacing * glm::dvec3(volume.geometry.dims);
  if (std::max({extent.x, extent.y, extent.z}) > kMostPlausible)
    volume.warnings.push_back(
        fmt::format("By what the file says the volume is {:.0f} x {:.0f} x {:.0f} mm, larger than any probe "
                    "sees; its lengths may be in millimetres though it calls them centimetres.",
                    extent.x, extent.y, extent.z));
}

// Volumes of bytes one after another; lengths are in the unit of ultrasound regions, cm.
DicomVolume qlabVolume(const DicomItem& root, DicomPixels& p, const fs::path& path) {
  constexpr int kCentimetres = 3;
  const int slices = root.whole(tag::kPhilipsSlices).value_or(0), steps = p.frames;
  const glm::dvec3 told(root.number(tag::kDeltaX).value_or(0), root.number(tag::kDeltaY).value_or(0),
                        root.number(tag::kPhilipsDeltaZ).value_or(0));
  require(slices >= 2 && slices <= 65535 && std::int64_t(slices) * steps <= 100'000 && p.samples == 1,
          "{} is a Philips volume that does not tell its slices; export it from QLAB again.", path.string());
  const bool isKnown = root.whole(tag::kUnitsX) == kCentimetres && root.whole(tag::kUnitsY) == kCentimetres &&
                       root.whole(tag::kPhilipsUnitsZ).value_or(kCentimetres) == kCentimetres &&
                       std::min({told.x, told.y, told.z}) > 0;
  require(!p.isPacked() && p.length / std::uint64_t(slices) / std::uint64_t(steps) >= p.frameBytes(),
          "{} ends before all of its {} volumes of {} slices; get a fresh copy.", path.string(), steps,
          slices);
  p.frames = slices * steps;
  DicomVolume volume = inOrder(p, slices, isKnown ? 10.0 * told : glm::dvec3(1), "DICOM, Philips");
  volume.spacingKnown = isKnown;
  volume.stepSeconds = std::max(0.0, root.number(tag::kFrameTime).value_or(0) / 1000);
  warnOfExtent(volume);
  return volume;
}

// Lengths are in mm, and texts though their type is another.
DicomVolume philipsVolume(const DicomItem& root, const DicomPixels& p, const fs::path& path) {
  const std::vector<double> mm = root.numbers(tag::kPhilipsSpacing), dims = root.numbers(tag::kPhilipsDims);
  require(mm.size() >= 3 && std::min({mm[0], mm[1], mm[2]}) > 0,
          "{} is a Philips volume that does not tell its spacing; export it from QLAB as Cartesian DICOM.",
          path.string());
  const int told = dims.size() >= 3 && dims[2] >= 2 && dims[2] <= 65535 ? int(dims[2]) : p.frames;
  const int slices = p.frames % told == 0 ? told : p.frames;
  DicomVolume volume = inOrder(p, slices, {mm[0], mm[1], mm[2]}, "DICOM, Philips");
  if (volume.timeSteps > 1)
    volume.stepSeconds = std::max(0.0, root.number(tag::kFrameTime).value_or(0) / 1000);
  return volume;
}

// One length for all axes, in thousandths of a millimetre where a ratio of lengths should be; the origin is in the middle.
DicomVolume eigenVolume(const DicomItem& root, const DicomPixels& p, const fs::path& path) {
  double mm = root.number(tag::kEigenSpacing).value_or(0);
  const double ratio = root.number(tag::kAspectRatio).value_or(0) / 1000;
  const bool differ = mm > 0 && ratio > 0 && std::abs(mm - ratio) > 0.01 * mm;
  if (!(mm > 0)) mm = ratio;
  require(mm > 0, "{} is a volume of Eigen's Artemis that does not tell its spacing; export it as NRRD.",
          path.string());
  DicomVolume volume = inOrder(p, p.frames, glm::dvec3(mm), "DICOM, Eigen");
  volume.geometry.origin = -0.5 * mm * glm::dvec3(volume.geometry.dims - 1);
  if (differ)
    volume.warnings.push_back(
        fmt::format("The file says {:.4g} mm and {:.4g} mm of its voxels; the first is used.", mm, ratio));
  return volume;
}

}  // namespace

std::optional<DicomPixels> makersPixels(const DicomItem& root) {
  const DicomElement* voxels = root.find(tag::kPhilipsVoxels);
  const std::vector<double> dims = root.numbers(tag::kPhilipsDims);
  if (!voxels || dims.size() < 3) return {};
  for (const double d : dims)
    if (d < 2 || d > 65535 || d != std::floor(d)) return {};
  DicomPixels p;
  p.columns = int(dims[0]), p.rows = int(dims[1]), p.frames = int(dims[2]);
  p.offset = voxels->offset, p.length = voxels->length;
  if (p.length / p.frameBytes() < std::uint64_t(p.frames)) return {};
  return p;
}

std::optional<DicomVolume> makersVolume(const DicomItem& root, DicomPixels& pixels, const fs::path& path) {
  const std::string uid = root.text(tag::kSopClass);
  if (uid == kQlab) return qlabVolume(root, pixels, path);
  if (pixels.frames < 2 || hasFrameGroups(root)) return {};
  if (root.find(tag::kPhilipsSpacing)) return philipsVolume(root, pixels, path);
  const bool isEigen = root.text(tag::kManufacturer) == "Eigen" && root.text(tag::kModelName) == "Artemis";
  if (isEigen && uid == kUltrasoundFrames) return eigenVolume(root, pixels, path);
  return {};
}

}  // namespace sonoskin
