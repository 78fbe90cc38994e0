#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/io/headers/frame_poses.h"

namespace sonoskin {

// picturePoses: where each picture lies, by whatever chain of transforms leads from the picture to a frame
// that stands still: "Reference", else "World", else "Tracker", as PLUS and fCal name them. Each transform is
// taken both ways.
//   input   count  of pictures
//   output  from pixels of a picture whose rows run to the marked side and whose columns run away from the
//           probe, to mm; nothing for a picture that the tracker or the scanner calls invalid
//   errors  Error: which transform is missing, and what to add to the header
std::vector<std::optional<glm::dmat4>> picturePoses(const FramePoses& poses, std::size_t count,
                                                    const std::filesystem::path& path);

// orientedPixels: from the pixels of a file to those of a picture in the orientation "MF" of PLUS: M and U
// run to and from the marked side, F and N away from and to the probe.
//   errors  Error: an orientation that is none of these
glm::dmat4 orientedPixels(const std::string& orientation, int width, int height,
                          const std::filesystem::path& path);

}  // namespace sonoskin
