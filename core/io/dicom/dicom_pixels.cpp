#include "core/io/dicom/dicom_pixels.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/io/dicom/dicom_codec.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

DicomColour colourOf(const std::string& name, int samples, const fs::path& path) {
  static const std::map<std::string, DicomColour> colours{
      {"MONOCHROME1", DicomColour::inverted},
      {"MONOCHROME2", DicomColour::grey},
      {"PALETTE COLOR", DicomColour::palette},
      {"RGB", DicomColour::rgb},
      {"YBR_FULL", DicomColour::ybr},
      {"YBR_FULL_422", DicomColour::ybr422},
      {"YBR_ICT", DicomColour::rgb},
      {"YBR_RCT", DicomColour::rgb}};  // turned back as they are unpacked
  const auto found = colours.find(name);
  if (found == colours.end() && name.empty()) return samples == 3 ? DicomColour::rgb : DicomColour::grey;
  require(found != colours.end(),
          "{} has colours of a kind that is not read here; save it in grey, or as RGB.", path.string());
  const bool three = found->second >= DicomColour::rgb;
  require(samples == (three ? 3 : 1), "{} has a header that contradicts itself; get a fresh copy.",
          path.string());
  return found->second;
}

// [DICOM PS3.3, C.7.6.3.1.5, C.7.6.3.1.6]
DicomPalette paletteOf(const DicomItem& root, const fs::path& path) {
  require(!root.find(tag::kSegmentedPalette),
          "{} has colours in a palette of segments, which is not read here; save it in grey, or as RGB.",
          path.string());
  DicomPalette palette;
  for (unsigned c = 0; c < 3; ++c) {
    const std::vector<double> about = root.numbers(tag::kPalette + c);
    const DicomElement* table = root.find(tag::kPaletteRed + c);
    const bool isWhole = about.size() == 3 && table && about[0] >= 0 && about[0] <= 65536 &&
                         about[1] >= -65536 && about[1] <= 65536;
    require(isWhole, "{} lacks the palette of its colours; get a fresh copy.", path.string());
    const std::size_t count = about[0] == 0 ? 65536 : std::size_t(about[0]);
    const std::string& bytes = table->value;
    const bool wide = bytes.size() >= 2 * count;  // 8 bits may lie alone, or in 16
    require(bytes.size() >= count, "{} has a palette that is too short; get a fresh copy.", path.string());
    // A first value below zero is written as what it is modulo 65536.
    palette.first = int(about[1]);
    std::vector<std::uint8_t>& colours = palette.colours[c];
    colours.resize(count);
    const unsigned high = about[2] == 16 ? 1 : 0;
    for (std::size_t v = 0; v < count; ++v) colours[v] = std::uint8_t(bytes[wide ? 2 * v + high : v]);
  }
  return palette;
}

// Where the frames begin in the pieces that packed pixels come in [DICOM PS3.5, A.4].
std::vector<std::size_t> firstPiecesOf(const DicomPixels& p, const DicomElement& element,
                                       const DicomItem& root, DicomSource& source) {
  const std::size_t frames = std::size_t(p.frames);
  std::vector<std::size_t> first;
  if (frames == 1) return {0};
  if (p.pieces.size() == frames) {
    for (std::size_t f = 0; f < frames; ++f) first.push_back(f);
    return first;
  }
  std::vector<std::uint64_t> starts;
  const auto [tableAt, tableBytes] = element.fragments.front();
  const DicomElement* extended = root.find(tag::kFrameStarts);
  const std::size_t word = extended ? 8 : 4;
  const std::uint64_t bytes = extended ? extended->length : tableBytes;
  if (bytes == word * frames) {
    const auto table = source.read(extended ? extended->offset : tableAt, bytes);
    for (std::size_t f = 0; f < frames; ++f) {
      std::uint64_t start = 0;
      for (std::size_t b = 0; b < word; ++b) start |= std::uint64_t(table[word * f + b]) << (8 * b);
      starts.push_back(start);
    }
  }
  std::uint64_t at = 0;
  for (std::size_t i = 0; i < p.pieces.size(); ++i) {
    std::uint8_t head[2] = {};
    if (starts.empty() && p.pieces[i].second >= 2) source.read(p.pieces[i].first, 2, head);
    const bool begins = starts.empty() ? head[0] == 0xFF && (head[1] == 0xD8 || head[1] == 0x4F)
                                       : std::ranges::binary_search(starts, at);
    if (begins) first.push_back(i);
    at += 8 + p.pieces[i].second;
  }
  return first;
}

void locate(DicomPixels& p, const DicomDataSet& set, DicomSource& source) {
  const fs::path& path = source.path();
  const DicomElement* element = set.root.find(tag::kPixels);
  for (const DicomTag other : {tag::kFloatPixels, tag::kDoublePixels})
    if (!element && (element = set.root.find(other))) {
      p.isFloat = true;
      p.allocated = p.stored = other == tag::kFloatPixels ? 32 : 64;
      p.highBit = p.stored - 1;
    }
  require(element != nullptr, "{} holds no pixels; choose a file with pictures.", path.string());
  p.offset = element->offset, p.length = element->length;
  if (element->fragments.empty()) {
    require(p.frameBytes() <= p.length / std::uint64_t(p.frames),
            "{} ends before all of its {} frames, or says that it has more; get a fresh copy.", path.string(),
            p.frames);
    return;
  }
  p.pieces.assign(element->fragments.begin() + 1, element->fragments.end());
  require(!p.pieces.empty(), "{} holds no pixels; get a fresh copy.", path.string());
  p.firstPieces = firstPiecesOf(p, *element, set.root, source);
  require(p.firstPieces.size() == std::size_t(p.frames),
          "{} does not tell where its {} frames begin; get a fresh copy, or save it unpacked.", path.string(),
          p.frames);
}

void checkBits(const DicomPixels& p, const fs::path& path) {
  const bool plain = p.allocated == 8 || p.allocated == 16 || p.allocated == 32;
  require(plain && p.stored >= 1 && p.stored <= p.allocated && p.highBit < p.allocated &&
              p.highBit >= p.stored - 1,
          "{} has pixels of {} bits in {}, which are not read here; save it with 8 or 16 bits.",
          path.string(), p.stored, p.allocated);
}

}  // namespace

std::uint64_t DicomPixels::frameBytes() const {
  const std::uint64_t pixels = framePixels(), sample = std::uint64_t(allocated) / 8;
  return colour == DicomColour::ybr422 && !isPacked() ? pixels * 2 * sample
                                                      : pixels * std::uint64_t(samples) * sample;
}

DicomPixels pixelsOf(const DicomDataSet& set, DicomSource& source) {
  const DicomItem& root = set.root;
  const fs::path& path = source.path();
  DicomPixels p;
  const auto take = [&](DicomTag tag, int otherwise) { return root.whole(tag).value_or(otherwise); };
  require(root.find(tag::kPixels) || root.find(tag::kFloatPixels) || root.find(tag::kDoublePixels),
          "{} holds no pixels; choose a file with pictures.", path.string());
  p.columns = take(tag::kColumns, 0), p.rows = take(tag::kRows, 0), p.frames = take(tag::kFrames, 1);
  constexpr int kMostFrames = 100'000;
  require(p.columns >= 1 && p.columns <= 65535 && p.rows >= 1 && p.rows <= 65535 && p.frames >= 1 &&
              p.frames <= kMostFrames,
          "{} says that it has {} frames of {} x {} pixels; get a fresh copy.", path.string(), p.frames,
          p.columns, p.rows);
  p.samples = take(tag::kSamples, 1);
  p.allocated = take(tag::kAllocated, 8), p.stored = take(tag::kStored, p.allocated);
  p.highBit = take(tag::kHighBit, p.stored - 1);
  p.isSigned = take(tag::kSigned, 0) == 1, p.isPlanar = take(tag::kPlanar, 0) == 1;
  p.syntax = set.syntax, p.bigEndian = set.bigEndian;
  p.colour = colourOf(root.text(tag::kPhotometric), p.samples, path);
  require((p.colour != DicomColour::ybr422 || p.columns % 2 == 0) && !(p.isSigned && p.components() > 1),
          "{} has a header that contradicts itself; get a fresh copy.", path.string());
  if (!root.find(tag::kFloatPixels) && !root.find(tag::kDoublePixels)) checkBits(p, path);
  if (p.colour == DicomColour::palette) p.palette = paletteOf(root, path);
  locate(p, set, source);
  p.padding = root.whole(tag::kPadding), p.paddingLimit = root.whole(tag::kPaddingLimit);
  return p;
}

NumberType scaledType(const DicomPixels& p, const std::vector<DicomScale>& scales) {
  if (p.isFloat) return p.allocated == 64 ? NumberType::float64 : NumberType::float32;
  if (p.colour == DicomColour::palette) return NumberType::uint8;
  const auto changes = [](const DicomScale& s) { return s.slope != 1 || s.intercept != 0; };
  if (p.components() > 1 || std::ranges::none_of(scales, changes)) {
    if (p.allocated == 8) return p.isSigned ? NumberType::int8 : NumberType::uint8;
    if (p.allocated == 16) return p.isSigned ? NumberType::int16 : NumberType::uint16;
    return p.isSigned ? NumberType::int32 : NumberType::uint32;
  }
  const double most = std::exp2(p.stored - (p.isSigned ? 1 : 0)) - 1, least = p.isSigned ? -most - 1 : 0;
  double low = 0, high = 0;
  for (const DicomScale& s : scales) {
    if (s.slope != std::floor(s.slope) || s.intercept != std::floor(s.intercept)) return NumberType::float32;
    const double a = s.slope * least + s.intercept, b = s.slope * most + s.intercept;
    low = std::min({low, a, b}), high = std::max({high, a, b});
  }
  if (low >= -32768 && high <= 32767) return NumberType::int16;
  if (low >= 0 && high <= 65535) return NumberType::uint16;
  return std::max(-low, high) < 2e9 ? NumberType::int32 : NumberType::float32;
}

// Value and limit are bits like the pixels' own: whether they are negative is said by the pixels' representation,
// whatever type the elements have. Where white is 0, the pixels are turned, and so they are turned too.
std::optional<Padding> paddingOf(const DicomPixels& p, const DicomScale& scale) {
  if (!p.padding || p.components() != 1 || p.isFloat) return {};
  const int white = (1 << std::min(p.stored, 16)) - 1;
  const auto scaled = [&](int given) {
    const bool turned = p.colour == DicomColour::inverted;
    const int bits = turned ? (p.isSigned ? -1 - given : white - std::min(given & 0xFFFF, white)) : given;
    const double pixel = p.isSigned ? double(std::int16_t(bits)) : double(std::uint16_t(bits));
    return float(scale.slope * pixel + scale.intercept);
  };
  const float a = scaled(*p.padding), b = scaled(p.paddingLimit.value_or(*p.padding));
  return Padding{std::min(a, b), std::max(a, b)};
}

}  // namespace sonoskin
