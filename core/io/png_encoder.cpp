#include "core/io/png_encoder.h"

#include <libdeflate.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "core/base/error.h"

namespace sonoskin {
namespace {

// Pictures are dithered: higher levels cost a multiple for a few per cent.
constexpr int kLevel = 1;

using Bytes = std::vector<std::uint8_t>;

// PaddedRow: one row with a black pixel before it, which is what filters see left of the first.
struct PaddedRow {
  Bytes bytes;
  const std::uint8_t* here = nullptr;
  const std::uint8_t* left = nullptr;

  PaddedRow(int width, int channels)
      : bytes(std::size_t(channels) * std::size_t(width + 1)),
        here(bytes.data() + channels),
        left(bytes.data()) {}
  PaddedRow(const PaddedRow&) = delete;
  PaddedRow& operator=(const PaddedRow&) = delete;

  void take(const std::uint8_t* rgba, int width, int channels) {
    std::uint8_t* to = bytes.data() + channels;
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) to[channels * x + c] = rgba[4 * x + c];
  }
};

// The neighbour that lies nearest to left + up - upper left.
std::uint8_t paeth(int left, int up, int corner) {
  const int fromLeft = std::abs(up - corner), fromUp = std::abs(left - corner),
            fromCorner = std::abs(left + up - 2 * corner);
  const bool takesLeft = fromLeft <= fromUp && fromLeft <= fromCorner;
  return std::uint8_t(takesLeft ? left : fromUp <= fromCorner ? up : corner);
}

// The row's differences under one filter, by its number in the format; returns the sum of their sizes. Loops without
// branches, which the compiler turns into vectors.
unsigned filterRow(int filter, const PaddedRow& row, const PaddedRow& above, Bytes& out) {
  const std::uint8_t *r = row.here, *left = row.left, *up = above.here, *corner = above.left;
  const std::size_t size = out.size();
  std::uint8_t* o = out.data();
  if (filter == 1)
    for (std::size_t i = 0; i < size; ++i) o[i] = std::uint8_t(r[i] - left[i]);
  else if (filter == 2)
    for (std::size_t i = 0; i < size; ++i) o[i] = std::uint8_t(r[i] - up[i]);
  else if (filter == 3)
    for (std::size_t i = 0; i < size; ++i) o[i] = std::uint8_t(r[i] - (left[i] + up[i]) / 2);
  else
    for (std::size_t i = 0; i < size; ++i) o[i] = std::uint8_t(r[i] - paeth(left[i], up[i], corner[i]));
  unsigned sum = 0;
  for (std::size_t i = 0; i < size; ++i) sum += unsigned(std::abs(int(std::int8_t(o[i]))));
  return sum;
}

int channelsNeeded(const Image& image) {
  std::uint8_t alpha = 255;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) alpha &= image.rgba[i];
  return alpha == 255 ? 3 : 4;
}

Bytes deflate(const Bytes& data) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(kLevel), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  Bytes packed(libdeflate_zlib_compress_bound(compressor.get(), data.size()));
  packed.resize(
      libdeflate_zlib_compress(compressor.get(), data.data(), data.size(), packed.data(), packed.size()));
  return packed;
}

// The most significant byte first.
void addNumber(Bytes& png, std::size_t number) {
  for (const int shift : {24, 16, 8, 0}) png.push_back(std::uint8_t(number >> shift));
}

// One part: length, name, content and their sum.
void addPart(Bytes& png, std::string_view name, const Bytes& content) {
  addNumber(png, content.size());
  const std::size_t begin = png.size();
  png.insert(png.end(), name.begin(), name.end());
  png.insert(png.end(), content.begin(), content.end());
  addNumber(png, libdeflate_crc32(0, png.data() + begin, png.size() - begin));
}

}  // namespace

std::vector<std::uint8_t> filterRows(const Image& image, int channels) {
  const std::size_t row = std::size_t(channels) * std::size_t(image.width);
  Bytes filtered;
  filtered.reserve((row + 1) * std::size_t(image.height));
  std::array<PaddedRow, 2> rows{PaddedRow(image.width, channels), PaddedRow(image.width, channels)};
  Bytes tried(row), best(row);
  for (int y = 0; y < image.height; ++y) {
    PaddedRow& here = rows[std::size_t(y) % 2];
    const PaddedRow& above = rows[std::size_t(y + 1) % 2];
    here.take(image.rgba.data() + 4 * std::size_t(image.width) * std::size_t(y), image.width, channels);
    unsigned least = ~0u;
    int chosen = 0;
    for (int filter = 1; filter <= 4; ++filter) {
      const unsigned sum = filterRow(filter, here, above, tried);
      if (sum >= least) continue;
      least = sum;
      chosen = filter;
      best.swap(tried);
    }
    filtered.push_back(std::uint8_t(chosen));
    filtered.insert(filtered.end(), best.begin(), best.end());
  }
  return filtered;
}

std::vector<std::uint8_t> encodePng(const Image& image) {
  const std::size_t bytes = 4 * std::size_t(image.width) * std::size_t(image.height);
  require(image.width > 0 && image.height > 0 && image.rgba.size() == bytes,
          "A picture of {} x {} pixels with {} bytes cannot be written; it needs four bytes a pixel.",
          image.width, image.height, image.rgba.size());
  const int channels = channelsNeeded(image);
  const Bytes packed = deflate(filterRows(image, channels));
  // A part's length has 31 bits.
  require(packed.size() < 1u << 31, "A picture of {} x {} pixels could not be packed; make it smaller.",
          image.width, image.height);
  Bytes header;
  addNumber(header, std::size_t(image.width));
  addNumber(header, std::size_t(image.height));
  constexpr std::uint8_t kDepth = 8, kColour = 2, kColourAlpha = 6;
  for (const std::uint8_t byte :
       {kDepth, channels == 4 ? kColourAlpha : kColour, std::uint8_t(0), std::uint8_t(0), std::uint8_t(0)})
    header.push_back(byte);
  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  png.reserve(packed.size() + 64);
  addPart(png, "IHDR", header);
  addPart(png, "IDAT", packed);
  addPart(png, "IEND", {});
  return png;
}

}  // namespace sonoskin
