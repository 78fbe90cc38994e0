#pragma once

#include "core/io/dicom/dicom_stacks.h"

namespace sonoskin {

// sweepOf: the volume of a file with several frames that have no places of their own.
//   input   frames  as framesOf
//   output  slices along the frames' normal, at the distance that Spacing Between Slices or the offsets of a dose tell, from
//           the file's one place, or from 0. Of unknown spacing, with a warning, where nothing tells of distance or time.
//           Refused where frames follow each other in time alone: that is a film.
// Frame Time is milliseconds, and never a distance.
DicomVolume sweepOf(const DicomItem& root, std::vector<DicomFrame> frames, const DicomPixels& pixels,
                    const std::filesystem::path& path);

// transducerBeam: how the sound goes through a volume whose frames lie in the frame of reference of ultrasound
// [DICOM PS3.3, C.8.24.2]: from its apex, along the transducer's y axis; without a matrix towards the volume's middle.
//   output  nothing where the file tells no apex
std::optional<Beam> transducerBeam(const DicomItem& root, const Geometry& geometry);

}  // namespace sonoskin
