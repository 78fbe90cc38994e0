// What a packed frame says of its size and colours itself.
#include <algorithm>
#include <cstring>
#include <optional>
#include <span>

#include "core/io/dicom/dicom_codec.h"

namespace sonoskin {
namespace {

using Bytes = std::span<const std::uint8_t>;

// Walks over the segments of a JPEG or JPEG 2000 stream up to its pixels: look(marker, content) ends it with true.
template <class Look>
void eachSegment(Bytes stream, const Look& look) {
  std::size_t at = 2;
  while (at + 4 <= stream.size() && stream[at] == 0xFF) {
    const unsigned marker = stream[at + 1];
    if (marker == 0xFF) {  // fill
      ++at;
      continue;
    }
    if (marker == 0x01 || (marker >= 0xD0 && marker <= 0xD9)) return;  // without a length: none is due here
    const std::size_t length = std::size_t(stream[at + 2]) << 8 | stream[at + 3];
    if (length < 2 || at + 2 + length > stream.size()) return;
    if (look(marker, stream.subspan(at + 4, length - 2))) return;
    at += 2 + length;
  }
}

bool begins(Bytes bytes, std::string_view mark) {
  return bytes.size() >= mark.size() && !std::memcmp(bytes.data(), mark.data(), mark.size());
}

// Frame: the header of a JPEG's picture, and the marks before it.
struct Frame {
  unsigned marker = 0;
  Bytes content;
  bool isJfif = false;
  std::optional<unsigned> adobe;

  unsigned word(std::size_t at) const { return unsigned(content[at]) << 8 | content[at + 1]; }
  // Of whole numbers that are predicted, which hardly anybody turns into YCbCr.
  bool isLossless() const { return marker % 4 == 3; }
};

Frame frameOf(Bytes stream) {
  constexpr unsigned kJpegLs = 0xF7;
  Frame frame;
  eachSegment(stream, [&](unsigned marker, Bytes content) {
    if (marker == 0xE0 && begins(content, {"JFIF\0", 5})) frame.isJfif = true;
    if (marker == 0xEE && content.size() >= 12 && begins(content, "Adobe")) frame.adobe = content[11];
    const bool isFrame =
        (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC) ||
        marker == kJpegLs;
    if (isFrame) frame.marker = marker, frame.content = content;
    return isFrame || marker == 0xDA;
  });
  return frame;
}

std::optional<DicomColour> jpegColour(Bytes stream) {
  const Frame frame = frameOf(stream);
  const Bytes content = frame.content;
  if (content.size() < 6 + 3 * 3 || content[5] != 3) return {};
  if (frame.isJfif && !frame.isLossless()) return DicomColour::ybr;
  if (frame.adobe) return *frame.adobe == 1 ? DicomColour::ybr : DicomColour::rgb;
  if (content[6] == 'R' && content[9] == 'G' && content[12] == 'B') return DicomColour::rgb;
  if (content[7] != content[10] || content[7] != content[13]) return DicomColour::ybr;
  return {};
}

// A stream whose components were mixed comes out as red, green and blue [ITU-T T.800, A.6.1].
bool mixesComponents(Bytes stream) {
  bool mixes = false;
  eachSegment(stream, [&](unsigned marker, Bytes content) {
    if (marker == 0x52 && content.size() >= 5) mixes = content[4] == 1;
    return marker == 0x52;
  });
  return mixes;
}

// StreamSize: what a stream tells of its pixels; `bits` of the widest sample.
struct StreamSize {
  unsigned width = 0, height = 0, samples = 0, bits = 0;
};

std::optional<StreamSize> jpegSize(Bytes stream) {
  const Frame frame = frameOf(stream);
  if (frame.content.size() < 6) return {};
  return StreamSize{frame.word(3), frame.word(1), frame.content[5], frame.content[0]};
}

std::uint64_t bigEndian(Bytes bytes, std::size_t at, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t b = 0; b < count; ++b) number = number << 8 | bytes[at + b];
  return number;
}

// The first segment is the size [ITU-T T.800, A.5.1]. Nothing where samples lie farther apart than pixels.
std::optional<StreamSize> jpeg2000Size(Bytes stream) {
  std::optional<StreamSize> size;
  eachSegment(stream, [&](unsigned marker, Bytes content) {
    if (marker != 0x51 || content.size() < 36) return true;
    const auto number = [&](std::size_t at) { return unsigned(bigEndian(content, at, 4)); };
    StreamSize found{number(2) - number(10), number(6) - number(14), unsigned(bigEndian(content, 34, 2))};
    if (content.size() != 36 + 3 * std::size_t(found.samples)) return true;
    for (std::size_t c = 36; c < content.size(); c += 3) {
      found.bits = std::max(found.bits, (content[c] & 0x7Fu) + 1);
      if (content[c + 1] != 1 || content[c + 2] != 1) return true;
    }
    size = found;
    return true;
  });
  return size;
}

}  // namespace

DicomColour streamColour(const DicomPixels& p, const std::vector<std::uint8_t>& packed) {
  if (p.samples != 3 || packed.size() < 4) return p.colour;
  const DicomColour told = p.colour == DicomColour::ybr422 ? DicomColour::ybr : p.colour;
  if (packed[0] == 0xFF && packed[1] == 0xD8) return jpegColour(packed).value_or(told);
  if (packed[0] == 0xFF && packed[1] == 0x4F && mixesComponents(packed)) return DicomColour::rgb;
  return told;
}

std::vector<std::uint8_t> unboxed(std::vector<std::uint8_t> packed) {
  constexpr std::string_view kSignature{"\0\0\0\x0CjP  ", 8};
  if (!begins(packed, kSignature)) return packed;
  std::size_t at = 0;
  while (packed.size() - at >= 16) {
    std::uint64_t length = bigEndian(packed, at, 4), head = 8;
    if (length == 1) length = bigEndian(packed, at + 8, 8), head = 16;
    if (length == 0) length = packed.size() - at;
    if (length < head || length > packed.size() - at) break;
    if (begins(Bytes(packed).subspan(at + 4), "jp2c")) {
      const auto from = packed.begin() + std::ptrdiff_t(at);
      return {from + std::ptrdiff_t(head), from + std::ptrdiff_t(length)};
    }
    at += length;
  }
  return packed;
}

bool streamFits(const DicomPixels& p, const std::vector<std::uint8_t>& packed) {
  if (p.syntax == "1.2.840.10008.1.2.5") return true;  // RLE, which does not tell
  if (packed.size() < 4 || packed[0] != 0xFF) return false;
  const std::optional<StreamSize> size = packed[1] == 0xD8   ? jpegSize(packed)
                                         : packed[1] == 0x4F ? jpeg2000Size(packed)
                                                             : std::nullopt;
  return size && size->width == unsigned(p.columns) && size->height == unsigned(p.rows) &&
         size->samples == unsigned(p.samples) && size->bits <= unsigned(p.allocated);
}

}  // namespace sonoskin
