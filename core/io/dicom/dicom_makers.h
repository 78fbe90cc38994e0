#pragma once

#include <optional>
#include <string>

#include "core/io/dicom/dicom_stacks.h"

namespace sonoskin {

// refuseOtherKinds: files that hold no volume that can be read here, each with what to do instead: documents, reports,
// meshes, lists, and volumes that only their maker's own programs read.
//   errors  Error: it is such a file
void refuseOtherKinds(const DicomItem& root, const std::filesystem::path& path);

// makersVolume: a volume whose place only its maker's own elements tell: Philips QLAB Cartesian and Affinity, iU22, Eigen
// Artemis. None of this was ever checked against a file from such a machine: it follows open readers (SlicerHeart,
// ITK-SNAP, GDCM's examples).
//   pixels  of the file; their frames become the slices of all time steps
//   output  nothing: it is of none of these
//   errors  Error: its elements contradict each other
std::optional<DicomVolume> makersVolume(const DicomItem& root, DicomPixels& pixels,
                                        const std::filesystem::path& path);

// makersPixels: those of a file whose voxels lie in an element of Philips' own (iU22), which pixelsOf does not know.
std::optional<DicomPixels> makersPixels(const DicomItem& root);

}  // namespace sonoskin
