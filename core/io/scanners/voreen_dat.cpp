#include "core/io/scanners/voreen_dat.h"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/headers/data_files.h"
#include "core/io/scanners/raw_numbers.h"
#include "core/io/text_keys.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// As Voreen, Inviwo and ImageVis3D write them, without what counts numbers per voxel.
std::optional<NumberType> formatNumber(std::string_view name) {
  constexpr std::pair<std::string_view, NumberType> formats[] = {
      {"char", NumberType::int8},        {"int8", NumberType::int8},      {"uchar", NumberType::uint8},
      {"uint8", NumberType::uint8},      {"byte", NumberType::uint8},     {"short", NumberType::int16},
      {"int16", NumberType::int16},      {"ushort", NumberType::uint16},  {"uint16", NumberType::uint16},
      {"ushort_12", NumberType::uint16}, {"int", NumberType::int32},      {"int32", NumberType::int32},
      {"uint", NumberType::uint32},      {"uint32", NumberType::uint32},  {"float", NumberType::float32},
      {"float32", NumberType::float32},  {"double", NumberType::float64}, {"float64", NumberType::float64}};
  for (const auto& [word, type] : formats)
    if (word == name) return type;
  return {};
}

// UCHAR3 and UCHAR4 are colours of their own; else ObjectModel tells: I, RGB or RGBA. QVis writes RGBA for grey bytes too: a
// file that has the very size of grey ones holds these.
struct Kind {
  NumberType type = NumberType::uint8;
  int components = 1;
};
Kind kindOf(const KeyText& text, std::uint64_t voxels, std::uint64_t bytes) {
  std::string format = lowerCase(text.valueOf("Format").value_or(""));
  Kind kind;
  if (format.ends_with('3') || format.ends_with('4')) {
    if (const auto colour = formatNumber(std::string_view(format).substr(0, format.size() - 1)))
      return {*colour, format.back() - '0'};
  }
  const auto type = formatNumber(format);
  require(
      type.has_value(),
      "{} has numbers of a Format that is not known here; UCHAR, USHORT, SHORT, UINT, INT, FLOAT and DOUBLE "
      "are.",
      text.path().string());
  kind.type = *type;
  const std::string model = lowerCase(text.valueOf("ObjectModel").value_or("i"));
  const int told = model == "rgb" ? 3 : model == "rgba" ? 4 : 1;
  require(told > 1 || model == "i" || model == "density" || model == "scalar",
          "{} has an ObjectModel that is not known here; I, RGB and RGBA are.", text.path().string());
  const bool isGrey = told == 4 && bytes / numberTypeBytes(kind.type) == voxels;
  kind.components = isGrey ? 1 : told;
  return kind;
}

ByteOrder orderOf(const KeyText& text) {
  std::string order = lowerCase(
      text.valueOf("ByteOrder")
          .value_or(text.valueOf("Endianess").value_or(text.valueOf("Endianness").value_or("little"))));
  require(order.starts_with("little") || order.starts_with("big"),
          "{} has a byte order that is not known here; little-endian and big-endian are.",
          text.path().string());
  return order.starts_with("big") ? ByteOrder::big : ByteOrder::little;
}

glm::ivec3 dimsOf(const KeyText& text) {
  const auto resolution = text.threeOf("Resolution");
  require(resolution.has_value(), "{} gives no Resolution; get a fresh copy.", text.path().string());
  glm::ivec3 dims(0);
  for (int a = 0; a < 3; ++a) {
    const double count = (*resolution)[std::size_t(a)];
    require(count >= 2 && count <= 65535 && count == std::floor(count),
            "{} gives {} as one number of its Resolution; 2 to 65535 are possible.", text.path().string(),
            count);
    dims[a] = int(count);
  }
  return dims;
}

int framesOf(const KeyText& text) {
  if (!text.valueOf("NumFrames")) return 1;
  const double frames = text.numberOf("NumFrames");
  require(frames >= 1 && frames <= 65535 && frames == std::floor(frames),
          "{} gives {} as NumFrames; 1 to 65535 are possible.", text.path().string(), frames);
  return int(frames);
}

}  // namespace

LoadedVolume readVoreenDat(const fs::path& path, const ReadOptions& options, const Progress& progress) {
  progress.update(0);
  const KeyText text(path, ':');
  const auto qvis = text.valueOf("ObjectFileName"), inviwo = text.valueOf("RawFile");
  const auto name = qvis ? qvis : inviwo;
  require(name && !name->empty(),
          "{} names no ObjectFileName or RawFile: it is no header of Voreen, Inviwo or QVis; choose another "
          "file.",
          path.string());
  RawNumbers numbers;
  numbers.file = besideHeader(path, *name);
  LoadedVolume loaded;
  StoredVolume& stored = loaded.stored;
  stored.format = "Voreen .dat";
  stored.geometry.dims = dimsOf(text);
  const std::uint64_t voxels = countNumbers(stored.geometry.dims, 1, path);
  const Kind kind = kindOf(text, voxels * std::uint64_t(framesOf(text)), dataFileSize(numbers.file, path));
  stored.type = numbers.type = kind.type;
  stored.components = kind.components;
  stored.timeSteps = numbers.timeSteps = framesOf(text);
  numbers.step = options.time;
  numbers.byteOrder = orderOf(text);
  numbers.frame = voxels * std::uint64_t(kind.components);
  const auto thickness = text.threeOf("SliceThickness");
  stored.spacingKnown = thickness.has_value();
  if (thickness) stored.geometry.spacing = {(*thickness)[0], (*thickness)[1], (*thickness)[2]};
  if (text.valueOf("TransformMatrix"))
    log(LogLevel::warning, "The header places the volume in the world by a matrix, which is left out.");
  checkGeometry(stored, path);
  loaded.numbers = readNumbers(numbers, path);
  loaded.bytes = fileSize(path) + fileSize(numbers.file);
  progress.update(1);
  return loaded;
}

}  // namespace sonoskin
