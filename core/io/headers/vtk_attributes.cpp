#include "core/io/headers/vtk_attributes.h"

#include <fmt/format.h>

#include <map>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/header_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Words = std::vector<std::string_view>;

// Block: an array as a line announces it.
struct Block {
  NumberType type = NumberType::uint8;
  int components = 1;
  std::uint64_t count = 0;  // of points or cells
  double slope = 1;
};

NumberType typeOf(std::string_view word, const fs::path& path) {
  const auto type = numberTypeOf(lowerCase(word));
  require(type.has_value(),
          "{} has numbers of a type that is not known here; save it with whole numbers or as float.",
          path.string());
  return *type;
}

int countOf(std::string_view word, int most, const fs::path& path) {
  const auto count = parseNumber<int>(word);
  require(count && *count >= 1 && *count <= most,
          "{} does not say how many numbers a voxel has; get a fresh copy.", path.string());
  return *count;
}

// How many words a line must have, and which numbers it announces for each point.
Block announced(const std::string& keyword, const Words& line, bool binary, const fs::path& path) {
  static const std::map<std::string, int, std::less<>> fixed{
      {"vectors", 3},    {"normals", 3},      {"tensors", 9},   {"tensors6", 6},
      {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
  const std::size_t needed = keyword == "texture_coordinates" ? 4 : 3;
  require(line.size() >= needed,
          "{} has a line behind its POINT_DATA that is not complete; get a fresh copy.", path.string());
  Block block;
  if (keyword == "scalars") {
    block.type = typeOf(line[2], path);
    block.components = line.size() > 3 ? countOf(line[3], 4, path) : 1;
  } else if (keyword == "color_scalars") {
    block.type = binary ? NumberType::uint8 : NumberType::float32;  // words are from 0 to 1
    block.slope = binary ? 1 : 255;
    block.components = countOf(line[2], 4, path);
  } else if (keyword == "texture_coordinates") {
    block.components = countOf(line[2], 3, path);
    block.type = typeOf(line[3], path);
  } else {
    const auto found = fixed.find(keyword);
    require(found != fixed.end(),
            "{} has a line behind its POINT_DATA that is not known here; save it again without.",
            path.string());
    block.components = found->second;
    block.type = typeOf(line[2], path);
  }
  return block;
}

// The line LOOKUP_TABLE after scalars, which some programs leave out.
void skipTableName(VtkText& text) {
  const std::uintmax_t at = text.position();
  std::string begin;
  try {
    begin = lowerCase(text.line().value_or(""));
  } catch (const Error&) {  // numbers, not text
  }
  if (!begin.starts_with("lookup_table")) text.seek(at);
}

// Search: what has been found so far, and among what it is looked for.
struct Search {
  std::uint64_t points = 0, cells = 0;
  bool ofCells = false;
  int arrays = 0;
  std::optional<VtkArray> scalars[2], fields[2];  // of points, of cells
};

void keep(Search& search, const Block& block, bool scalars, std::uintmax_t offset) {
  ++search.arrays;
  auto& place = (scalars ? search.scalars : search.fields)[search.ofCells];
  if (!place && (block.components == 1 || block.components >= 3) && block.components <= 4)
    place = VtkArray{block.type, block.components, offset, search.ofCells, block.slope};
}

std::uint64_t elements(const Search& search) { return search.ofCells ? search.cells : search.points; }

// Arrays of a field: each a line "name components tuples type" and its numbers.
void readField(const Words& line, VtkText& text, Search* search, const fs::path& path) {
  const int arrays = line.size() >= 3 ? parseNumber<int>(line[2]).value_or(-1) : -1;
  require(arrays >= 0 && arrays <= 10'000, "{} has a FIELD that is not complete; get a fresh copy.",
          path.string());
  for (int n = 0; n < arrays; ++n) {
    auto next = text.line();
    while (next && lowerCase(*next) == "metadata") {
      skipVtkMetadata(text);
      next = text.line();
    }
    const Words parts = words(next ? *next : std::string_view());
    const bool whole = parts.size() == 4;
    const int components = whole ? parseNumber<int>(parts[1]).value_or(0) : 0;
    const std::int64_t tuples = whole ? parseNumber<std::int64_t>(parts[2]).value_or(-1) : -1;
    require(tuples >= 0 && tuples <= std::int64_t(1) << 33 && components >= 1 && components <= 65536,
            "{} has a FIELD that is not complete; get a fresh copy.", path.string());
    const Block block{typeOf(parts[3], path), components, std::uint64_t(tuples)};
    if (search && block.count == elements(*search)) keep(*search, block, false, text.position());
    text.skipNumbers(block.type, block.count * std::uint64_t(components));
  }
}

void readTable(const Words& line, VtkText& text, const fs::path& path) {
  const auto size = line.size() == 3 ? parseNumber<std::uint32_t>(line[2]) : std::nullopt;
  require(size.has_value(), "{} has a LOOKUP_TABLE that is not complete; get a fresh copy.", path.string());
  text.skipNumbers(text.binary ? NumberType::uint8 : NumberType::float32, std::uint64_t(*size) * 4);
}

void enterSection(const Words& line, bool cells, Search& search, const fs::path& path) {
  search.ofCells = cells;
  const auto count = line.size() == 2 ? parseNumber<std::uint64_t>(line[1]) : std::nullopt;
  require(count && *count == elements(search),
          "The line {} in {} does not fit its DIMENSIONS; get a fresh copy.", line[0].substr(0, 20),
          path.string());
}

void readAttribute(const std::string& text_, VtkText& text, Search& search, const fs::path& path) {
  const Words line = words(text_);
  const std::string keyword = lowerCase(line[0]);
  if (keyword == "point_data" || keyword == "cell_data")
    return enterSection(line, keyword == "cell_data", search, path);
  if (keyword == "metadata") return skipVtkMetadata(text);
  if (keyword == "field") return readField(line, text, &search, path);
  if (keyword == "lookup_table") return readTable(line, text, path);
  const Block block = announced(keyword, line, text.binary, path);
  if (keyword == "scalars") skipTableName(text);
  const bool scalars = keyword == "scalars" || keyword == "color_scalars";
  if (scalars)
    keep(search, block, true, text.position());
  else
    ++search.arrays;
  text.skipNumbers(block.type, elements(search) * std::uint64_t(block.components));
}

std::optional<VtkArray> bestOf(const Search& search) {
  for (const auto* found : {&search.scalars[0], &search.scalars[1], &search.fields[0], &search.fields[1]})
    if (*found) return *found;
  return {};
}

}  // namespace

void skipVtkMetadata(VtkText& text) {
  while (const auto line = text.plainLine())
    if (trimmed(*line).empty()) return;
}

void skipVtkField(const Words& line, VtkText& text, const fs::path& path) {
  readField(line, text, nullptr, path);
}

VtkArray findVtkArray(const std::string& line, const glm::ivec3& points, VtkText& text,
                      const fs::path& path) {
  Search search;
  search.points = search.cells = 1;
  for (int a = 0; a < 3; ++a) {
    search.points *= std::uint64_t(points[a]);
    search.cells *= std::uint64_t(std::max(1, points[a] - 1));
  }
  std::optional<std::string> next = line;
  try {
    for (; next; next = text.line()) readAttribute(*next, text, search, path);
  } catch (const Error&) {  // what follows the voxels does not matter
    if (!search.scalars[0]) throw;
  }
  const auto found = bestOf(search);
  require(found.has_value(),
          "{} has no grey or coloured numbers for its points or cells; save one as SCALARS.", path.string());
  if (search.arrays > 1)
    log(LogLevel::warning,
        fmt::format("The file holds {} arrays of numbers; one of them is used, the others are left out.",
                    search.arrays));
  return *found;
}

}  // namespace sonoskin
