#pragma once

#include <filesystem>
#include <vector>

#include "core/io/dicom/dicom_stacks.h"

namespace sonoskin {

// DicomPlace: the frames at one place along the normal of all.
struct DicomPlace {
  double along = 0;  // mm
  std::vector<const DicomFrame*> frames;
};

// placesOf: the places of parallel frames, in their order.
std::vector<DicomPlace> placesOf(const std::vector<DicomFrame>& frames);

// setPlaces: the geometry of frames one at a place, or the reason why they have none.
//   input  places  two at least
void setPlaces(DicomVolume& volume, const std::vector<DicomPlace>& places, const std::filesystem::path& path);

}  // namespace sonoskin
