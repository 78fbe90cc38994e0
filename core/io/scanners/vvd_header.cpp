#include "core/io/scanners/vvd_header.h"

#include <expat.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

// Reading: what expat has come to. Elements count by their names, wherever they lie: <Volume> begins a volume, <RawData> and
// the <item> of its paths name its file, <MetaItem name=...> begins an item, and <value> or <row0> to <row3> are its numbers.
struct Reading {
  std::vector<VvdVolume> volumes;
  std::string item;
  bool isVoreen = false, damaged = false;
};

std::string_view attribute(const XML_Char** attributes, std::string_view name) {
  for (; *attributes; attributes += 2)
    if (attributes[0] == name) return attributes[1];
  return {};
}

double numberIn(Reading& reading, std::string_view text) {
  const auto number = parseNumber<double>(trimmed(text));
  reading.damaged |= !number || !std::isfinite(*number);
  return number.value_or(0);
}

glm::dvec3 vectorIn(Reading& reading, const XML_Char** attributes) {
  return {numberIn(reading, attribute(attributes, "x")), numberIn(reading, attribute(attributes, "y")),
          numberIn(reading, attribute(attributes, "z"))};
}

void takeRawData(Reading& reading, const XML_Char** attributes) {
  VvdVolume& volume = reading.volumes.back();
  volume.file = attribute(attributes, "filename");
  volume.format = attribute(attributes, "format");
  volume.dims = vectorIn(reading, attributes);
}

// A name of a file, as people can read it.
bool isName(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; });
}

void takeItem(Reading& reading, std::string_view element, const XML_Char** attributes) {
  VvdVolume& volume = reading.volumes.back();
  if (reading.item == "Offset" && element == "value") volume.offset = vectorIn(reading, attributes);
  if (reading.item == "Spacing" && element == "value") volume.spacing = vectorIn(reading, attributes);
  if (reading.item != "Transformation" || element.size() != 4 || !element.starts_with("row")) return;
  const int row = element.back() - '0';
  if (row < 0 || row > 3) return;
  glm::dmat4 matrix = volume.transformation.value_or(glm::dmat4(1));
  const glm::dvec3 xyz = vectorIn(reading, attributes);
  for (int c = 0; c < 3; ++c) matrix[c][row] = xyz[c];
  matrix[3][row] = numberIn(reading, attribute(attributes, "w"));
  volume.transformation = matrix;
}

void begin(void* data, const XML_Char* name, const XML_Char** attributes) {
  constexpr std::size_t kMostVolumes = 4096;
  Reading& reading = *static_cast<Reading*>(data);
  const std::string_view element = name;
  if (element == "VoreenData") reading.isVoreen = true;
  if (element == "Volume") reading.volumes.emplace_back();
  reading.damaged |= reading.volumes.size() > kMostVolumes;
  if (reading.volumes.empty() || reading.damaged) return;
  if (element == "RawData") takeRawData(reading, attributes);
  if (element == "item" && reading.volumes.back().file.empty())
    reading.volumes.back().file = attribute(attributes, "value");
  if (element == "MetaItem") reading.item = attribute(attributes, "name");
  takeItem(reading, element, attributes);
  reading.damaged |= !isName(reading.volumes.back().file);
}

void end(void* data, const XML_Char* name) {
  if (std::string_view(name) == "MetaItem") static_cast<Reading*>(data)->item.clear();
}

}  // namespace

std::vector<VvdVolume> readVvdHeader(const fs::path& path) {
  const std::string text = readText(path);
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                       XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Reading reading;
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), begin, end);
  const bool parsed = XML_Parse(parser.get(), text.data(), int(text.size()), XML_TRUE) == XML_STATUS_OK;
  require(parsed && reading.isVoreen && !reading.damaged,
          "{} is no header of Voreen that can be read; save it again with Voreen.", path.string());
  std::erase_if(reading.volumes, [](const VvdVolume& volume) { return volume.file.empty(); });
  require(!reading.volumes.empty(), "{} names no raw file of a volume; save it again with Voreen.",
          path.string());
  return reading.volumes;
}

}  // namespace sonoskin
