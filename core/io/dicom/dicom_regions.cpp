#include "core/io/dicom/dicom_regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

constexpr double kAlike = 0.01;

bool alike(const glm::dvec2& a, const glm::dvec2& b) {
  return std::abs(a.x - b.x) <= kAlike * a.x && std::abs(a.y - b.y) <= kAlike * a.y;
}

double area(const DicomRegion& r) {
  return double(r.most.x - r.least.x + 1) * double(r.most.y - r.least.y + 1);
}

// One that is a picture in space and has a scale.
std::optional<DicomRegion> regionOf(const DicomItem& item) {
  constexpr int kPlane = 1, kCentimetres = 3;
  constexpr double kMillimetres = 10;
  const auto corner = [&](DicomTag x, DicomTag y) {
    return glm::ivec2(item.whole(x).value_or(-1), item.whole(y).value_or(-1));
  };
  DicomRegion r{corner(tag::kRegionMinX, tag::kRegionMinY), corner(tag::kRegionMaxX, tag::kRegionMaxY), {}};
  r.spacing = kMillimetres * glm::abs(glm::dvec2(item.number(tag::kDeltaX).value_or(0),
                                                 item.number(tag::kDeltaY).value_or(0)));
  const bool isPlane = item.whole(tag::kRegionFormat).value_or(kPlane) == kPlane;
  const bool inSpace = item.whole(tag::kUnitsX) == kCentimetres && item.whole(tag::kUnitsY) == kCentimetres;
  const bool lies = r.least.x >= 0 && r.least.y >= 0 && r.most.x > r.least.x && r.most.y > r.least.y;
  return isPlane && inSpace && lies && r.spacing.x > 0 && r.spacing.y > 0 ? std::optional(r) : std::nullopt;
}

// The largest one, of tissue where there is one.
std::optional<DicomRegion> mainRegion(const DicomItem& root, std::vector<std::string>& warnings) {
  constexpr int kTissue = 1;
  std::optional<DicomRegion> main;
  bool isTissue = false, differ = false;
  for (const DicomItem& item : root.items(tag::kRegions)) {
    const auto region = regionOf(item);
    if (!region) continue;
    const bool tissue = item.whole(tag::kRegionData) == kTissue;
    if (main) differ = differ || !alike(main->spacing, region->spacing);
    if (!main || tissue > isTissue || (tissue == isTissue && area(*region) > area(*main)))
      main = region, isTissue = tissue;
  }
  if (differ)
    warnings.push_back(
        fmt::format("The pictures have regions of different scales; that of the largest, {:.4g} x {:.4g} mm, "
                    "is used for all.",
                    main->spacing.x, main->spacing.y));
  return main;
}

}  // namespace

std::optional<glm::dvec2> pixelSpacing(const DicomItem& item, DicomTag tag) {
  const std::vector<double> both = item.numbers(tag);
  if (both.size() < 2 || !(both[0] > 0) || !(both[1] > 0)) return {};
  return glm::dvec2(both[1], both[0]);
}

DicomSpacing spacingOf(const DicomItem& root) {
  DicomSpacing spacing;
  spacing.region = mainRegion(root, spacing.warnings);
  const auto told = pixelSpacing(root, tag::kPixelSpacing);
  if (spacing.region) {
    spacing.mm = spacing.region->spacing, spacing.known = true;
    if (told && !alike(*told, spacing.mm))
      spacing.warnings.push_back(
          fmt::format("The file has two scales: {:.4g} x {:.4g} mm from pixel to pixel in its ultrasound "
                      "region, which is used, and {:.4g} x {:.4g} mm for all of the picture.",
                      spacing.mm.x, spacing.mm.y, told->x, told->y));
    return spacing;
  }
  for (const DicomTag tag : {tag::kPixelSpacing, tag::kImagerPixelSpacing, tag::kScannedPixelSpacing})
    if (const auto found = pixelSpacing(root, tag)) {
      spacing.mm = *found, spacing.known = true;
      return spacing;
    }
  if (const auto ratio = pixelSpacing(root, tag::kAspectRatio)) spacing.mm.y = ratio->y / ratio->x;
  return spacing;
}

}  // namespace sonoskin
