#include "core/io/meshes/ply_header.h"

#include <array>

#include "core/base/error.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

std::optional<PlyType> typeOf(std::string_view name) {
  static constexpr std::array<std::array<std::string_view, 2>, 8> kNames{{{"char", "int8"},
                                                                          {"uchar", "uint8"},
                                                                          {"short", "int16"},
                                                                          {"ushort", "uint16"},
                                                                          {"int", "int32"},
                                                                          {"uint", "uint32"},
                                                                          {"float", "float32"},
                                                                          {"double", "float64"}}};
  for (std::size_t t = 0; t < kNames.size(); ++t)
    if (name == kNames[t][0] || name == kNames[t][1]) return PlyType(t);
  return {};
}

[[noreturn]] void failHeader(const fs::path& path) {
  throw Error(fmt::format("{} is not a complete PLY file; get a fresh copy.", path.string()));
}
// Adds what one line of the header says; false where it makes no sense.
bool addLine(const std::vector<std::string_view>& line, PlyHeader& header) {
  const std::string_view word = line[0];
  if (word == "comment" || word == "obj_info") return true;
  if (word == "format" && line.size() >= 2) {
    if (line[1] == "ascii")
      header.format = PlyFormat::text;
    else if (line[1] == "binary_little_endian")
      header.format = PlyFormat::little;
    else if (line[1] == "binary_big_endian")
      header.format = PlyFormat::big;
    else
      return false;
    return true;
  }
  if (word == "element" && line.size() == 3) {
    const auto count = parseNumber<std::uint64_t>(line[2]);
    if (count) header.elements.push_back({std::string(line[1]), *count, {}});
    return count.has_value();
  }
  if (word != "property" || header.elements.empty()) return false;
  PlyProperty property;
  const bool list = line.size() == 5 && line[1] == "list";
  if (!list && line.size() != 3) return false;
  const auto type = typeOf(line[list ? 3 : 1]);
  if (list) property.count = typeOf(line[2]);
  if (!type || (list && !property.count)) return false;
  property.type = *type;
  property.name = line.back();
  header.elements.back().properties.push_back(property);
  return true;
}

}  // namespace

std::size_t bytesOf(PlyType type) {
  return std::array<std::size_t, 8>{1, 1, 2, 2, 4, 4, 4, 8}[std::size_t(type)];
}

PlyHeader parsePlyHeader(std::string_view text, const fs::path& path) {
  PlyHeader header;
  HeaderLines lines(text, path);
  const auto magic = lines.next();
  if (!magic || trimmed(*magic) != "ply") failHeader(path);
  while (const auto line = lines.next()) {
    const auto parts = words(*line);
    if (parts.empty()) continue;
    if (parts[0] == "comment" || parts[0] == "obj_info") header.comments.append(*line).append("\n");
    if (parts[0] == "end_header") {
      header.bytes = lines.position();
      return header;
    }
    if (!addLine(parts, header)) failHeader(path);
  }
  failHeader(path);
}

}  // namespace sonoskin
