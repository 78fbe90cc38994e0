#include "core/io/dicom/dicom_sweep.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// Whether the file says that time passes from frame to frame [DICOM PS3.3, C.7.6.5, C.7.6.6].
bool isFilm(const DicomItem& root) {
  const std::vector<double> pointer = root.numbers(tag::kFrameIncrement);  // group, element
  const DicomTag next = pointer.size() < 2 ? 0 : DicomTag(pointer[0]) << 16 | DicomTag(pointer[1]);
  return next == tag::kFrameTime || next == tag::kFrameTimes ||
         root.number(tag::kFrameTime).value_or(0) > 0 || root.numbers(tag::kFrameTimes).size() > 1 ||
         root.number(tag::kCineRate).value_or(0) > 0;
}

// One offset for each frame, all the same distance apart; 0 where there are none.
double offsetStep(const DicomItem& root, std::size_t frames) {
  const std::vector<double> offsets = root.numbers(tag::kFrameOffsets);
  if (offsets.size() != frames) return 0;
  const double step = (offsets.back() - offsets.front()) / double(frames - 1);
  for (std::size_t f = 0; f < frames; ++f)
    if (std::abs(offsets[f] - offsets.front() - double(f) * step) > 0.1 * std::abs(step)) return 0;
  return step;
}

}  // namespace

DicomVolume sweepOf(const DicomItem& root, std::vector<DicomFrame> frames, const DicomPixels& pixels,
                    const fs::path& path) {
  const DicomFrame& first = frames.front();
  DicomVolume volume;
  Geometry& g = volume.geometry;
  double step = offsetStep(root, frames.size());
  if (step == 0) step = first.slices;
  g.dims = {pixels.columns, pixels.rows, int(frames.size())};
  g.spacing = {first.spacing, step != 0 ? std::abs(step) : 1};
  g.origin = first.position.value_or(glm::dvec3(0));
  g.direction = {first.row, first.column, first.normal() * (step < 0 ? -1.0 : 1.0)};
  volume.spacingKnown = first.spacingKnown && step != 0;
  if (step == 0 && isFilm(root))
    volume.refusal = Error(
        fmt::format("{} is a film: its {} frames follow each other in time, and nothing says that they are "
                    "slices of a volume; export the volume itself, or add Spacing Between Slices "
                    "(0018,0088) if they are slices of an even sweep.",
                    path.string(), frames.size()));
  else if (step == 0)
    volume.warnings.push_back(fmt::format(
        "The file does not say what its {} frames are; they are taken as slices of one volume, of a "
        "distance that is not known.",
        frames.size()));
  volume.frames = std::move(frames);
  return volume;
}

std::optional<Beam> transducerBeam(const DicomItem& root, const Geometry& g) {
  const std::vector<double> apex = root.numbers(tag::kApex), matrix = root.numbers(tag::kToTransducer);
  if (apex.size() < 3 || root.text(tag::kScanGeometry) == "PATIENT") return {};
  Beam beam;
  beam.apex = glm::dvec3(apex[0], apex[1], apex[2]);
  const glm::dvec3 middle = g.toWorld(0.5 * glm::dvec3(g.dims - 1)) - *beam.apex;
  // A matrix turns the volume's frame into the transducer's, so that its rows are the transducer's axes.
  const auto row = [&](std::size_t r) {
    return glm::dvec3(matrix[4 * r], matrix[4 * r + 1], matrix[4 * r + 2]);
  };
  const bool turned = matrix.size() >= 16 && std::abs(glm::length(row(1)) - 1) < 0.01;
  beam.axis = turned ? row(1) : middle;
  if (glm::length(beam.axis) < 1e-3) return {};
  beam.axis = glm::normalize(beam.axis) * (glm::dot(beam.axis, middle) < 0 ? -1.0 : 1.0);
  glm::dvec3 up = turned ? row(0) : g.direction[0];
  up -= glm::dot(up, beam.axis) * beam.axis;
  if (glm::length(up) < 0.1) up = g.direction[2] - glm::dot(g.direction[2], beam.axis) * beam.axis;
  beam.up = glm::normalize(up);
  return beam;
}

}  // namespace sonoskin
