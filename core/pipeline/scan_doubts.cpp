#include "core/pipeline/scan_doubts.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/pipeline/face_use.h"

namespace sonoskin {
namespace {

// Limits: beyond these a scan is doubted (the table in the header).
struct Limits {
  double sideways, dark, clear;
};
constexpr Limits kAnyScan{0.38, 0.25, 0.62}, kWithoutFace{0.35, 0.45, 0.68};
constexpr double kLeastRise = 2.5;      // of the noise
constexpr double kMostWidth = 4.5;      // mm
constexpr double kLeastLargest = 0.28;  // of the surface
constexpr double kMostSize = 350;       // mm: more than any probe sees
constexpr double kHounsfield = -300;    // values as low as this are Hounsfield units: fat has -100, air -1000

int percent(double share) { return int(100 * share + 0.5); }

// What the file tells.
std::string doubtOfFile(const Scan& scan) {
  if (!scan.modality.empty() && scan.modality != "US") {
    const std::string kind = scan.modality == "CT"   ? "a CT"
                             : scan.modality == "MR" ? "an MRI"
                                                     : fmt::format("of the kind {}", scan.modality);
    return fmt::format(
        "the file says that it is {}, not ultrasound: the surface may be anything but a baby's skin; open a "
        "3D "
        "ultrasound scan",
        kind);
  }
  if (scan.originalMin < kHounsfield)
    return fmt::format(
        "the values begin at {:g}, as in a CT and not in ultrasound: the surface may be anything but a "
        "baby's skin; open a 3D ultrasound scan",
        scan.originalMin);
  return {};
}

std::string doubtOfEdges(const ScanEvidence& e, const Limits& limits) {
  if (!e.hasEdges) return "there is but one grey in what was recorded, and so no surface; open another scan";
  if (e.rise < kLeastRise * e.noise)
    return "no border of skin and fluid rises from the noise: the surface is made of noise; record with more "
           "contrast, or open another scan";
  if (e.sideways > limits.sideways)
    return "edges face all ways alike, as in a CT or an MRI, and not the probe, as in ultrasound: the "
           "surface may "
           "not be skin; if this is a face in fluid, set scan.probeSide";
  return {};
}

std::string doubtOfFluid(const ScanEvidence& e, const Limits& limits) {
  if (e.dark < limits.dark)
    return fmt::format(
        "only {} % of what was recorded is as dark as fluid: the surface may be the border of any tissue; a "
        "face "
        "can be seen where fluid lies before it",
        percent(e.dark));
  if (e.clear < limits.clear)
    return fmt::format(
        "only {} % of the surface has fluid before it: it may not be skin; set scan.probeSide if the probe "
        "is "
        "elsewhere, or crop the volume to the face",
        percent(e.clear));
  if (e.width > kMostWidth)
    return fmt::format(
        "across the surface the grey rises over {:.1f} mm, too slowly for a border of skin and fluid: it may "
        "not "
        "be skin, or the spacing is wrong; look at the slices",
        e.width);
  if (e.largest < kLeastLargest)
    return fmt::format(
        "the surface is in pieces, the largest with {} % of it: they may not be skin; move "
        "classification.isoValue, or crop the volume to the face",
        percent(e.largest));
  return {};
}

// The most telling one of all that say that this is no skin.
std::string doubtOfSkin(const Scan& scan, const ScanEvidence& evidence, bool lacksFace) {
  if (std::string doubt = doubtOfFile(scan); !doubt.empty()) return doubt;
  const Limits& limits = lacksFace ? kWithoutFace : kAnyScan;
  if (std::string doubt = doubtOfEdges(evidence, limits); !doubt.empty()) return doubt;
  return doubtOfFluid(evidence, limits);
}

// A recording that is larger than any probe's.
std::string doubtOfSize(const Geometry& g) {
  const glm::dvec3 size = g.spacing * glm::dvec3(g.dims);
  const double longest = std::max({size.x, size.y, size.z});
  if (longest <= kMostSize) return {};
  return fmt::format("the scan would be {:.0f} mm across, more than probes see: is the spacing right?",
                     longest);
}

}  // namespace

std::vector<std::string> doubtsOf(const Scan& scan, const ScanEvidence& evidence, const FaceFit* face,
                                  const FaceOptions& options) {
  std::vector<std::string> doubts;
  const bool lacksFace = face && !isCertain(face, options);
  for (std::string doubt : {doubtOfSkin(scan, evidence, lacksFace), doubtOfSize(scan.volume->geometry),
                            scaleWarning(face, options)})
    if (!doubt.empty()) doubts.push_back(std::move(doubt));
  return doubts;
}

}  // namespace sonoskin
