#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace sonoskin::test {

// DicomText: an element whose value is a text, or the bytes of one.
struct DicomText {
  std::uint16_t group, element;
  const char* type;
  std::string value;
};

// DicomImage: one slice of a series, or a file of several frames, with what says how its numbers are meant.
//   numbers  columns x rows x frames, in bits of `allocated`, as they lie in the file
//   padding  PixelPaddingValue and PixelPaddingRangeLimit, in the same bits
struct DicomImage {
  int columns = 4, rows = 3, frames = 1;
  int allocated = 16, stored = 16;
  bool isSigned = false;
  std::vector<std::int32_t> numbers;
  std::optional<double> slope, intercept;
  std::optional<int> padding, paddingLimit;
  double place = 0;                     // along the slices' normal, mm
  std::optional<std::string> position;  // instead; empty: none is told
  std::string orientation = "1\\0\\0\\0\\1\\0";
  std::string spacing = "0.5\\0.5";  // empty: not told
  int number = 1;
  std::optional<std::string> instance;                     // its UID; else that of the series and the number
  std::string mediaStorage = "1.2.840.10008.5.1.4.1.1.2";  // CT image
  std::string modality = "CT";
  std::string photometric = "MONOCHROME2";
  std::string series = "1.2.3.4.5";
  bool explicitTypes = true;      // else they stand in the standard alone
  std::vector<DicomText> others;  // more elements
  bool paddingIsSigned = true;    // the type of the padding's elements follows the pixels'; else always US
};

// dicomItem: an item of a sequence with these elements.
inline std::string dicomItem(const std::string& elements) {
  std::string head("\xfe\xff\x00\xe0", 4);
  for (int b = 0; b < 4; ++b) head += char(elements.size() >> (8 * b) & 255);
  return head + elements;
}

// DicomBytes: elements one after another, little endian [DICOM PS3.5, 7.1.2, 7.1.3].
class DicomBytes {
 public:
  explicit DicomBytes(bool explicitTypes = true) : explicitTypes_(explicitTypes) {}
  void element(std::uint16_t group, std::uint16_t number, const char* type, std::string value) {
    if (value.size() % 2 != 0) value += std::strcmp(type, "UI") == 0 ? '\0' : ' ';
    add16(group), add16(number);
    if (explicitTypes_) bytes += type;
    const bool isLong = !std::strcmp(type, "OW") || !std::strcmp(type, "OB") || !std::strcmp(type, "SQ");
    if (explicitTypes_ && isLong) add16(0);
    if (explicitTypes_ && !isLong)
      add16(std::uint16_t(value.size()));
    else
      add32(std::uint32_t(value.size()));
    bytes += value;
  }
  void text(std::uint16_t group, std::uint16_t number, const char* type, const std::string& value) {
    element(group, number, type, value);
  }
  void number(std::uint16_t group, std::uint16_t element16, const char* type, int value) {
    element(group, element16, type, {char(value & 255), char(value >> 8 & 255)});
  }
  std::string bytes;

 private:
  void add16(std::uint16_t v) { bytes += {char(v & 255), char(v >> 8)}; }
  void add32(std::uint32_t v) { add16(std::uint16_t(v)), add16(std::uint16_t(v >> 16)); }

  bool explicitTypes_;
};

inline std::string pixelBytes(const DicomImage& image) {
  std::string bytes;
  for (const std::int32_t number : image.numbers)
    for (int b = 0; b < image.allocated / 8; ++b) bytes += char(number >> (8 * b) & 255);
  return bytes;
}

// dicomFile: the bytes of a file.
inline std::string dicomFile(const DicomImage& i) {
  const std::string instance = i.instance.value_or(i.series + "." + std::to_string(i.number));
  const char* eitherSign = i.isSigned && i.paddingIsSigned ? "SS" : "US";
  const std::string syntax = i.explicitTypes ? "1.2.840.10008.1.2.1" : "1.2.840.10008.1.2";
  DicomBytes meta, data(i.explicitTypes);
  meta.text(2, 2, "UI", i.mediaStorage), meta.text(2, 3, "UI", instance), meta.text(2, 16, "UI", syntax);
  data.text(8, 0x16, "UI", i.mediaStorage), data.text(8, 0x18, "UI", instance);
  data.text(8, 0x60, "CS", i.modality);
  data.text(0x20, 0xd, "UI", i.series + ".1"), data.text(0x20, 0xe, "UI", i.series);
  data.text(0x20, 0x13, "IS", std::to_string(i.number));
  const std::string position = i.position.value_or(fmt::format("0\\0\\{}", i.place));
  if (!position.empty()) data.text(0x20, 0x32, "DS", position);
  if (!i.orientation.empty()) data.text(0x20, 0x37, "DS", i.orientation);
  data.number(0x28, 2, "US", 1), data.text(0x28, 4, "CS", i.photometric);
  if (i.frames > 1) data.text(0x28, 8, "IS", std::to_string(i.frames));
  data.number(0x28, 0x10, "US", i.rows), data.number(0x28, 0x11, "US", i.columns);
  if (!i.spacing.empty()) data.text(0x28, 0x30, "DS", i.spacing);
  data.number(0x28, 0x100, "US", i.allocated), data.number(0x28, 0x101, "US", i.stored);
  data.number(0x28, 0x102, "US", i.stored - 1), data.number(0x28, 0x103, "US", i.isSigned);
  if (i.padding) data.number(0x28, 0x120, eitherSign, *i.padding);
  if (i.paddingLimit) data.number(0x28, 0x121, eitherSign, *i.paddingLimit);
  if (i.intercept) data.text(0x28, 0x1052, "DS", fmt::format("{}", *i.intercept));
  if (i.slope) data.text(0x28, 0x1053, "DS", fmt::format("{}", *i.slope));
  for (const DicomText& other : i.others) data.element(other.group, other.element, other.type, other.value);
  data.element(0x7fe0, 0x10, i.allocated == 8 ? "OB" : "OW", pixelBytes(i));
  DicomBytes length;
  length.element(2, 0, "UL", {char(meta.bytes.size() & 255), char(meta.bytes.size() >> 8 & 255), '\0', '\0'});
  return std::string(128, '\0') + "DICM" + length.bytes + meta.bytes + data.bytes;
}

}  // namespace sonoskin::test
