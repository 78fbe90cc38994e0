#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/io/dicom/dicom_pixels.h"
#include "core/io/dicom/dicom_regions.h"

namespace sonoskin {

// DicomMark: what may tell frames at the same place apart. The first three are of different pictures, the others of the
// same one at another time.
enum class DicomMark { kind, echo, diffusion, temporal, acquisition, trigger, time, content };
inline constexpr std::size_t kDicomMarks = 8;

// DicomFrame: a picture in a file, and where it lies.
//   file, index  of the files at hand, of the file's frames
//   group        frames of different ones never are of one volume: series, size, type, kind of data
//   position     of its first pixel's centre, mm, LPS; row and column: unit directions along these
//   spacing      along row and column, mm
//   slices       Spacing Between Slices, mm; 0: not told
//   isTissue     whether it holds what was recorded of tissue, not flow or what was made of it [C.8.24.6.3]
//   marks        NaN: not told
struct DicomFrame {
  int file = 0, index = 0;
  glm::ivec2 size{0};  // columns, rows
  std::size_t group = 0;
  std::optional<glm::dvec3> position;
  glm::dvec3 row{1, 0, 0}, column{0, 1, 0};
  bool hasOrientation = false;
  glm::dvec2 spacing{1};
  bool spacingKnown = false;
  double slices = 0;
  DicomScale scale;
  bool isTissue = true;
  std::array<double, kDicomMarks> marks = [] {
    std::array<double, kDicomMarks> none{};
    none.fill(std::numeric_limits<double>::quiet_NaN());
    return none;
  }();

  double mark(DicomMark m) const { return marks[std::size_t(m)]; }
  glm::dvec3 normal() const { return glm::cross(row, column); }
};

// framesOf: all frames of a file whose pictures have places of their own, be they in the file's own elements or in its
// functional groups [DICOM PS3.3, C.7.6.2, C.7.6.16].
std::vector<DicomFrame> framesOf(const DicomItem& root, const DicomPixels& pixels,
                                 const DicomSpacing& spacing);

// hasFrameGroups: whether the file tells of each frame what is its own.
bool hasFrameGroups(const DicomItem& root);

}  // namespace sonoskin
