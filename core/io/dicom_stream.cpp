// What a packed frame says of its colours itself.
#include <algorithm>
#include <cstring>
#include <optional>
#include <span>

#include "core/io/dicom_codec.h"

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
    const std::size_t length = std::size_t(stream[at + 2]) << 8 | stream[at + 3];
    if (length < 2 || at + 2 + length > stream.size()) return;
    if (look(marker, stream.subspan(at + 4, length - 2))) return;
    at += 2 + length;
  }
}

bool begins(Bytes bytes, std::string_view mark) {
  return bytes.size() >= mark.size() && !std::memcmp(bytes.data(), mark.data(), mark.size());
}

std::optional<DicomColour> jpegColour(Bytes stream) {
  bool isJfif = false;
  std::optional<unsigned> adobe;
  Bytes frame;
  eachSegment(stream, [&](unsigned marker, Bytes content) {
    if (marker == 0xE0 && begins(content, {"JFIF\0", 5})) isJfif = true;
    if (marker == 0xEE && content.size() >= 12 && begins(content, "Adobe")) adobe = content[11];
    const bool isFrame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (isFrame) frame = content;
    return isFrame || marker == 0xDA;
  });
  if (frame.size() < 6 + 3 * 3 || frame[5] != 3) return {};
  if (isJfif) return DicomColour::ybr;
  if (adobe) return *adobe == 1 ? DicomColour::ybr : DicomColour::rgb;
  if (frame[6] == 'R' && frame[9] == 'G' && frame[12] == 'B') return DicomColour::rgb;
  if (frame[7] != frame[10] || frame[7] != frame[13]) return DicomColour::ybr;
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

}  // namespace

DicomColour streamColour(const DicomPixels& p, const std::vector<std::uint8_t>& packed) {
  if (p.samples != 3 || packed.size() < 4) return p.colour;
  const DicomColour told = p.colour == DicomColour::ybr422 ? DicomColour::ybr : p.colour;
  if (packed[0] == 0xFF && packed[1] == 0xD8) return jpegColour(packed).value_or(told);
  if (packed[0] == 0xFF && packed[1] == 0x4F && mixesComponents(packed)) return DicomColour::rgb;
  return told;
}

}  // namespace sonoskin
