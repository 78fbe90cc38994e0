#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/dicom/dicom_frames.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// DicomVolume: frames that make one volume, or more of it in time.
//   frames    of the first time step, slice by slice along the normal, then of the next; empty for a maker's own file
//   geometry  of the slices as if each lay straight above the one before
//   shift     how far each lies across that instead, along rows and columns, mm
//   warnings  to be said when it is read
//   refusal   why it cannot be read
struct DicomVolume {
  std::vector<DicomFrame> frames;
  Geometry geometry;
  glm::dvec2 shift{0};
  bool spacingKnown = true, isTissue = true;
  int timeSteps = 1;
  double stepSeconds = 0;  // 0: not told
  std::string format = "DICOM", modality;
  std::optional<Beam> beam;
  std::vector<std::string> warnings;
  std::optional<Error> refusal;
  int file = 0;  // of the files at hand, the first one that it is of
};

// stacksOf: the volumes that frames with places make.
//   input   frames of any files; `path` is the one that a person gave, for sentences
//   method  frames of one group and one orientation, in the order of their places along their normal. Several at a place
//           are told apart by what their marks say: other pictures become volumes of their own, other times time steps.
//   output  volumes in the order of their first frames. Refused, each with its reason: slices that turn against each other,
//           that are not evenly spaced or miss some, that are shifted unevenly, that lie at the same place without a word why,
//           that have no place.
std::vector<DicomVolume> stacksOf(const std::vector<DicomFrame>& frames, const std::filesystem::path& path);

}  // namespace sonoskin
