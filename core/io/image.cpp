#include "core/io/image.h"

#include <stb_image.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/file_formats.h"
#include "core/io/png_encoder.h"

namespace sonoskin {
namespace {

constexpr int kMaxSide = 16384;
constexpr double kMostPacked = 1100;  // bytes that one of a packed stream can stand for, and a little more

// A number of four bytes, the most significant first.
std::size_t numberAt(const std::vector<std::uint8_t>& png, std::size_t at) {
  std::size_t number = 0;
  for (std::size_t b = 0; b < 4; ++b) number = number << 8 | png[at + b];
  return number;
}

// Whether every part of a PNG ends within it, to the one named IEND: stb takes the memory that a part asks for.
bool partsFit(const std::vector<std::uint8_t>& png) {
  constexpr std::size_t kMagicBytes = 8, kHead = 8,
                        kSum = 4;  // of a part: length and name before it, a sum behind
  for (std::size_t at = kMagicBytes; at + kHead <= png.size();) {
    const std::size_t end = at + kHead + numberAt(png, at) + kSum;
    if (end > png.size()) return false;
    if (!std::memcmp(&png[at + 4], "IEND", 4)) break;
    at = end;
  }
  return true;
}

// As the first part of a PNG tells by depth and colour type.
int bitsPerPixel(const std::vector<std::uint8_t>& png) {
  constexpr std::size_t kDepth = 24, kType = 25;
  constexpr int kChannels[] = {1, 0, 3, 1, 2, 0, 4};
  return png[kDepth] * kChannels[std::min<std::size_t>(png[kType], 6)];
}

}  // namespace

void writePng(const std::filesystem::path& path, const Image& image) {
  requireFormat(FileKind::picture, path);
  const std::vector<std::uint8_t> png = encodePng(image);
  writeBytes(path, png.data(), png.size());
}

Image readPng(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> png = readBytes(path);
  static constexpr std::uint8_t kMagic[] = {0x89, 'P', 'N', 'G'};
  require(png.size() > sizeof kMagic && png.size() < (1u << 30) &&
              !std::memcmp(png.data(), kMagic, sizeof kMagic),
          "{} is not a PNG picture; convert it to PNG.", path.string());
  Image image;
  int channels = 0;
  const int size = int(png.size());
  // The size is looked at before anything is allocated for the pixels.
  require(png.size() > 25, "{} is damaged or incomplete; get a fresh copy.", path.string());
  const std::size_t width = numberAt(png, 16), height = numberAt(png, 20);
  require(std::max(width, height) <= kMaxSide, "{} has {} x {} pixels, more than {} x {}; make it smaller.",
          path.string(), width, height, kMaxSide, kMaxSide);
  require(
      partsFit(png) && double(width) * double(height) * bitsPerPixel(png) / 8 <= kMostPacked * double(size),
      "{} is damaged: it declares more than it holds; get a fresh copy.", path.string());
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(png.data(), size, &image.width, &image.height, &channels, 4), stbi_image_free);
  require(pixels != nullptr, "{} is damaged or incomplete; get a fresh copy.", path.string());
  image.rgba.assign(pixels.get(), pixels.get() + 4 * std::size_t(image.width) * std::size_t(image.height));
  return image;
}

}  // namespace sonoskin
