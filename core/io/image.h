#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace sonoskin {

// Image: a picture of 8 bits per channel, sRGB, with straight alpha. Top row first.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // 4 * width * height
};

// writePng: writes a picture, atomically.
//   errors  Error: no pixels, or not 4 * width * height bytes; (system) the file cannot be written
void writePng(const std::filesystem::path& path, const Image& image);

// readPng: reads a picture of up to 16384 x 16384 pixels; grey and colour without alpha become opaque RGBA.
//   errors  Error: no such file, or not a complete PNG
Image readPng(const std::filesystem::path& path);

}  // namespace sonoskin
