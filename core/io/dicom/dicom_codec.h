#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/io/dicom/dicom_pixels.h"

namespace sonoskin {

// unpackFrame: the samples of one packed frame, side by side, in the bits that are allocated for them, little endian. The
// colours are those of the stream: see streamColour.
//   input   packed  the frame's pieces, one after the other
//   errors  Error: packed in a way that is not known here, or damaged
// JPEG of all kinds, JPEG-LS, JPEG 2000 and RLE, by GDCM, which sees nothing else of the file.
std::vector<std::uint8_t> unpackFrame(const DicomPixels& pixels, const std::vector<std::uint8_t>& packed,
                                      const std::filesystem::path& path);

// unboxed: the stream of JPEG 2000 alone where a frame has the boxes of a JP2 file around it [ITU-T T.800, I.5.4], so that what
// these say, such as a palette, is not applied; any other frame as it is.
std::vector<std::uint8_t> unboxed(std::vector<std::uint8_t> packed);

// streamFits: whether a packed frame is of the size and number of colours that the file tells, in no more bits than it has for
// them: GDCM takes that for granted, and reads or writes beyond the end where it is not so. RLE does not tell, and fits.
bool streamFits(const DicomPixels& pixels, const std::vector<std::uint8_t>& packed);

// streamColour: what the samples of a packed frame are: a JPEG stream says more than the file around it, which calls YCbCr
// RGB often enough. In this order: a JFIF mark is of YCbCr [JFIF 1.02, p. 2], but for lossless ones; Adobe's mark tells [ITU-T T.872, 6.5.3];
// components named R, G and B; colour in a lower resolution, which only YCbCr has; else the file.
DicomColour streamColour(const DicomPixels& pixels, const std::vector<std::uint8_t>& packed);

}  // namespace sonoskin
