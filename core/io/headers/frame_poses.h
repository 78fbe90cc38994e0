#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <set>
#include <string>

#include "core/io/header_text.h"

namespace sonoskin {

// FramePoses: what a row of tracked pictures says of where each lies, as PLUS writes it. Names are such as
// "ProbeToTracker"; matrices are homogeneous, mm, from the first frame's coordinates to the second's.
//   fixed        those that hold for all pictures, such as "ImageToProbe"
//   perFrame     the others, by the number of the picture; not there where the tracker lost it
//   invalid      numbers of pictures that are none
//   orientation  UltrasoundImageOrientation: to which sides the picture's axes run; empty: not told
struct FramePoses {
  std::map<std::string, glm::dmat4, std::less<>> fixed;
  std::map<std::string, std::map<std::size_t, glm::dmat4>, std::less<>> perFrame;
  std::set<std::size_t> invalid;
  std::string orientation;
};

// posesFrom: of the keys of a header: "Seq_Frame0007_ProbeToTrackerTransform", "ImageToProbeTransform",
// "Seq_Frame0007_ImageStatus".
//   errors  Error: a transform is not sixteen numbers with a last row of 0 0 0 1, or its frame has no number
FramePoses posesFrom(const HeaderKeys& keys, const std::filesystem::path& path);

// placesManyFrames: whether keys of a header give a transform to more than its first picture.
bool placesManyFrames(const HeaderKeys& keys);

}  // namespace sonoskin
