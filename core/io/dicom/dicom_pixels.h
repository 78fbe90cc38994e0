#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/io/dicom/dicom_data_set.h"
#include "core/io/stored_volume.h"

namespace sonoskin {

// DicomColour: what the samples of a pixel are [DICOM PS3.3, C.7.6.3.1.2].
//   inverted   grey whose 0 is white
//   ybr        luminance and two differences of colour; ybr422: these once for two pixels
enum class DicomColour { grey, inverted, palette, rgb, ybr, ybr422 };

// DicomPalette: red, green and blue of the values from `first` on, in 8 bits.
struct DicomPalette {
  int first = 0;
  std::array<std::vector<std::uint8_t>, 3> colours;
};

// DicomPixels: how the pixels of a file lie in it and what they are.
//   syntax     the transfer syntax's UID
//   offset     of plain pixels, `length` bytes; packed ones have pieces instead, and of each frame the first one
struct DicomPixels {
  int columns = 0, rows = 0, frames = 1, samples = 1;
  int allocated = 8, stored = 8, highBit = 7;  // bits of a sample
  bool isSigned = false, isPlanar = false, isFloat = false, bigEndian = false;
  DicomColour colour = DicomColour::grey;
  DicomPalette palette;
  std::string syntax;
  std::uint64_t offset = 0, length = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> pieces;
  std::vector<std::size_t> firstPieces;
  std::optional<int> padding, paddingLimit;  // bits as the pixels' own

  bool isPacked() const { return !pieces.empty(); }
  int components() const { return colour <= DicomColour::inverted ? 1 : 3; }
  std::size_t framePixels() const { return std::size_t(columns) * std::size_t(rows); }
  std::uint64_t frameBytes() const;  // as they lie in a file that is not packed
};

// pixelsOf: of a file.
//   errors  Error: it has none; they are of a kind that is not read here; fewer bytes than they need
DicomPixels pixelsOf(const DicomDataSet& set, DicomSource& source);

// DicomScale: what turns a stored number into the one that it means; without `given` the file has none.
struct DicomScale {
  double slope = 1, intercept = 0;
  bool given = false;
};

// scaledType: the type that holds the numbers of these pixels after all of these scales: their own where no scale changes
// them, whole numbers where those are, else float.
NumberType scaledType(const DicomPixels& pixels, const std::vector<DicomScale>& scales);

// paddingOf: the range that the file says means nothing, after its scale [DICOM PS3.3, C.7.5.1.1.2].
std::optional<Padding> paddingOf(const DicomPixels& pixels, const DicomScale& scale);

// readFrame: the numbers of one frame as `type`, components() side by side; colour as red, green and blue.
//   errors  Error: the file cannot be read, or its packed pixels not be unpacked
void readFrame(DicomSource& source, const DicomPixels& pixels, int frame, const DicomScale& scale,
               NumberType type, std::uint8_t* out);

}  // namespace sonoskin
