#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What a PLY file says of itself before its numbers. [Turk 1994]
namespace sonoskin {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyFormat { text, little, big };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count;  // of a list
};
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};
struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
  std::string comments;
  std::size_t bytes = 0;
};

// bytesOf: of one binary number.
std::size_t bytesOf(PlyType type);

// parsePlyHeader: of the text of a whole file, or its beginning.
//   errors  Error: no complete header of PLY
PlyHeader parsePlyHeader(std::string_view text, const std::filesystem::path& path);

}  // namespace sonoskin
