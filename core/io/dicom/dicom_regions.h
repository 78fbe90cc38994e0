#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/io/dicom/dicom_data_set.h"

namespace sonoskin {

// DicomRegion: where in a picture of ultrasound the picture itself lies, from pixel to pixel, both of it.
struct DicomRegion {
  glm::ivec2 least{0}, most{0};
  glm::dvec2 spacing{1};  // mm
};

// DicomSpacing: from pixel to pixel within a frame.
//   mm       along its rows and along its columns; of unknown size where `known` is false, and then of the right ratio
//   region   that the spacing is of, where one tells it
struct DicomSpacing {
  glm::dvec2 mm{1};
  bool known = false;
  std::optional<DicomRegion> region;
  std::vector<std::string> warnings;
};

// spacingOf: of a file's frames, where they do not tell it one by one. In this order: the region of ultrasound, in cm
// [DICOM PS3.3, C.8.5.5]; Pixel Spacing; Imager Pixel Spacing and Nominal Scanned Pixel Spacing, which are measured in front
// of the body or on paper [10.7.1.3]; Pixel Aspect Ratio, for the ratio alone.
DicomSpacing spacingOf(const DicomItem& root);

// pixelSpacing: Pixel Spacing of an item; the standard has the distance of rows first [10.7.1.1].
std::optional<glm::dvec2> pixelSpacing(const DicomItem& item, DicomTag tag);

}  // namespace sonoskin
