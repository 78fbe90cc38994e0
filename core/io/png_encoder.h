#pragma once

#include <cstdint>
#include <vector>

#include "core/io/image.h"

namespace sonoskin {

// encodePng: the bytes of a PNG file, without an alpha channel where every pixel is opaque.
//   errors  Error: no pixels, or not 4 * width * height bytes
//   cost    one thread; about 15 ms for 1280x960, of which 3 ms choose the rows' filters
std::vector<std::uint8_t> encodePng(const Image& image);

// filterRows: the rows of a picture as PNG packs them: the filter's number, then the differences that it leaves. For each
// row that one of sub, up, average and Paeth whose differences are least in sum [PNG specification, 12.8].
//   channels  3 or 4 of each pixel's four
//   output    height * (1 + channels * width) bytes
std::vector<std::uint8_t> filterRows(const Image& image, int channels);

}  // namespace sonoskin
