#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/headers/declared_data.h"

namespace sonoskin {

// reconstructPictures: the volume that a row of tracked pictures shows, with the beam of the one in the
// middle: parallel, down its columns.
//   input   data  with poses
//   output  of bytes where the pictures are of bytes, else of floats; in the frame of the reference or the
//           tracker; the mask is what they covered
//   errors  Error: a transform is missing, and which; fewer than two pictures have a place; pictures in
//           colours other than red, green and blue; Cancelled
LoadedVolume reconstructPictures(const DeclaredData& data, const std::filesystem::path& path,
                                 const Progress& progress = {});

}  // namespace sonoskin
