#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"

namespace sonoskin {

// makeFilm: pictures one after another as a film (H.264 in MP4), over and over until it is three seconds long, by the program
// ffmpeg.
//   input   pictures   PNG files of one size in one folder
//           perSecond  > 0
//   output  whether ffmpeg is there and has made it; nothing is left of it otherwise
//   errors  Error (system): nothing can be written beside the pictures; Cancelled
bool makeFilm(const std::vector<std::filesystem::path>& pictures, double perSecond,
              const std::filesystem::path& film, const Progress& progress = {});

}  // namespace sonoskin
