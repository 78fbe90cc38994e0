// The numbers of one frame.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/base/error.h"
#include "core/io/dicom/dicom_codec.h"
#include "core/io/dicom/dicom_pixels.h"

namespace sonoskin {
namespace {

using Values = std::vector<double>;

std::vector<std::uint8_t> packedFrame(DicomSource& source, const DicomPixels& p, int frame) {
  const std::size_t from = p.firstPieces[std::size_t(frame)];
  const std::size_t to =
      std::size_t(frame) + 1 < p.firstPieces.size() ? p.firstPieces[std::size_t(frame) + 1] : p.pieces.size();
  std::vector<std::uint8_t> packed;
  for (std::size_t i = from; i < to; ++i) {
    const auto piece = source.read(p.pieces[i].first, p.pieces[i].second);
    packed.insert(packed.end(), piece.begin(), piece.end());
  }
  return packed;
}

// What is stored in the bits that are used, with its sign; the others may hold anything.
template <class Bits>
void takeBits(const std::vector<std::uint8_t>& bytes, const DicomPixels& p, Values& out) {
  const int shift = p.highBit + 1 - p.stored;
  const std::uint64_t mask = p.stored == 64 ? ~0ull : (1ull << p.stored) - 1, sign = 1ull << (p.stored - 1);
  const bool swaps = p.bigEndian && !p.isPacked();
  for (std::size_t v = 0; v < out.size(); ++v) {
    Bits bits;
    std::memcpy(&bits, bytes.data() + v * sizeof(Bits), sizeof(Bits));
    if (swaps) {
      auto* raw = reinterpret_cast<std::uint8_t*>(&bits);
      std::reverse(raw, raw + sizeof(Bits));
    }
    const std::uint64_t value = (std::uint64_t(bits) >> shift) & mask;
    out[v] = p.isSigned && (value & sign) ? double(std::int64_t(value | ~mask)) : double(value);
  }
}

template <class Bits, class Float>
void takeFloats(const std::vector<std::uint8_t>& bytes, const DicomPixels& p, Values& out) {
  for (std::size_t v = 0; v < out.size(); ++v) {
    std::uint8_t raw[sizeof(Bits)];
    std::memcpy(raw, bytes.data() + v * sizeof(Bits), sizeof(Bits));
    if (p.bigEndian) std::reverse(raw, raw + sizeof(Bits));
    Float value;
    std::memcpy(&value, raw, sizeof(Float));
    out[v] = double(value);
  }
}

Values valuesOf(const std::vector<std::uint8_t>& bytes, const DicomPixels& p) {
  Values values(bytes.size() / (std::size_t(p.allocated) / 8));
  if (p.isFloat && p.allocated == 32)
    takeFloats<std::uint32_t, float>(bytes, p, values);
  else if (p.isFloat)
    takeFloats<std::uint64_t, double>(bytes, p, values);
  else if (p.allocated == 8)
    takeBits<std::uint8_t>(bytes, p, values);
  else if (p.allocated == 16)
    takeBits<std::uint16_t>(bytes, p, values);
  else
    takeBits<std::uint32_t>(bytes, p, values);
  return values;
}

// Two pixels are Y Y Cb Cr there [DICOM PS3.3, C.7.6.3.1.2]; an odd last one is not.
Values fromPairs(const Values& pairs, std::size_t pixels) {
  Values values(3 * pixels);
  for (std::size_t v = 0; v < pixels; ++v) {
    const double* pair = &pairs[v / 2 * 4];
    values[3 * v] = pair[v % 2], values[3 * v + 1] = pair[2], values[3 * v + 2] = pair[3];
  }
  return values;
}

Values fromPlanes(const Values& planes, std::size_t pixels) {
  Values values(planes.size());
  for (std::size_t v = 0; v < pixels; ++v)
    for (std::size_t c = 0; c < 3; ++c) values[3 * v + c] = planes[c * pixels + v];
  return values;
}

Values fromPalette(const Values& places, const DicomPalette& palette) {
  Values values(3 * places.size());
  for (std::size_t v = 0; v < places.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& colours = palette.colours[c];
      const double place = std::clamp(places[v] - palette.first, 0.0, double(colours.size() - 1));
      values[3 * v + c] = colours[std::size_t(place)];
    }
  return values;
}

// Luminance and differences of the full range to red, green and blue [DICOM PS3.3, C.7.6.3.1.2].
void toRgb(Values& values, int stored) {
  const double most = std::exp2(stored) - 1, middle = std::exp2(stored - 1);
  for (std::size_t v = 0; v + 2 < values.size(); v += 3) {
    const double y = values[v], b = values[v + 1] - middle, r = values[v + 2] - middle;
    const double rgb[3] = {y + 1.402 * r, y - 0.344136 * b - 0.714136 * r, y + 1.772 * b};
    for (std::size_t c = 0; c < 3; ++c) values[v + c] = std::clamp(std::round(rgb[c]), 0.0, most);
  }
}

template <class T>
void store(const Values& values, std::uint8_t* out) {
  for (std::size_t v = 0; v < values.size(); ++v) {
    const T number = T(values[v]);
    std::memcpy(out + v * sizeof(T), &number, sizeof(T));
  }
}

void storeAs(NumberType type, const Values& values, std::uint8_t* out) {
  switch (type) {
    case NumberType::int8:
      return store<std::int8_t>(values, out);
    case NumberType::uint8:
      return store<std::uint8_t>(values, out);
    case NumberType::int16:
      return store<std::int16_t>(values, out);
    case NumberType::uint16:
      return store<std::uint16_t>(values, out);
    case NumberType::int32:
      return store<std::int32_t>(values, out);
    case NumberType::uint32:
      return store<std::uint32_t>(values, out);
    case NumberType::float64:
      return store<double>(values, out);
    default:
      return store<float>(values, out);
  }
}

Values pixelValues(DicomSource& source, const DicomPixels& p, int frame) {
  std::vector<std::uint8_t> bytes;
  DicomColour colour = p.colour;
  if (p.isPacked()) {
    const auto packed = unboxed(packedFrame(source, p, frame));
    require(
        streamFits(p, packed),
        "{} has packed pixels of another size or number of bits than it says, or packed in a way that is not "
        "known here; get a fresh copy, or save it unpacked.",
        source.path().string());
    colour = streamColour(p, packed);
    bytes = unpackFrame(p, packed, source.path());
  } else {
    bytes = source.read(p.offset + std::uint64_t(frame) * p.frameBytes(), p.frameBytes());
  }
  Values values = valuesOf(bytes, p);
  if (colour == DicomColour::ybr422) values = fromPairs(values, p.framePixels());
  if (p.samples == 3 && p.isPlanar && !p.isPacked() && colour != DicomColour::ybr422)
    values = fromPlanes(values, p.framePixels());
  if (colour == DicomColour::palette) values = fromPalette(values, p.palette);
  if (colour == DicomColour::ybr || colour == DicomColour::ybr422) toRgb(values, p.stored);
  if (colour == DicomColour::inverted)
    for (double& v : values) v = (p.isSigned ? -1 : std::exp2(p.stored) - 1) - v;
  return values;
}

}  // namespace

void readFrame(DicomSource& source, const DicomPixels& p, int frame, const DicomScale& scale, NumberType type,
               std::uint8_t* out) {
  Values values = pixelValues(source, p, frame);
  if (p.components() == 1 && (scale.slope != 1 || scale.intercept != 0))
    for (double& v : values) v = scale.slope * v + scale.intercept;
  storeAs(type, values, out);
}

}  // namespace sonoskin
