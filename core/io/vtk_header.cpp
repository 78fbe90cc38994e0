// Headers of VTK legacy files with structured points (vtk.org/wp-content/uploads/2015/04/file-formats.pdf).
#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/header_text.h"
#include "core/io/stored_volume.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

std::optional<NumberType> typeOf(std::string_view name) {
  static const std::map<std::string_view, NumberType> types{
      {"char", NumberType::int8},          {"unsigned_char", NumberType::uint8},
      {"short", NumberType::int16},        {"unsigned_short", NumberType::uint16},
      {"int", NumberType::int32},          {"unsigned_int", NumberType::uint32},
      {"long", NumberType::int64},         {"unsigned_long", NumberType::uint64},
      {"float", NumberType::float32},      {"double", NumberType::float64},
      {"vtktypeint64", NumberType::int64}, {"vtktypeuint64", NumberType::uint64}};
  const auto found = types.find(name);
  if (found == types.end()) return {};
  return found->second;
}

// Three numbers after the keyword of a line.
glm::dvec3 three(const std::vector<std::string_view>& line, const fs::path& path) {
  glm::dvec3 v(0);
  for (std::size_t a = 0; a < 3; ++a) {
    const auto number = line.size() == 4 ? parseNumber<double>(line[a + 1]) : std::nullopt;
    require(number.has_value(), "The line {} in {} is not three numbers; get a fresh copy.",
            line[0].substr(0, 20), path.string());
    v[int(a)] = *number;
  }
  return v;
}

void readScalars(const std::vector<std::string_view>& line, const fs::path& path, StoredVolume& stored) {
  const auto type = line.size() >= 3 ? typeOf(lowerCase(line[2])) : std::nullopt;
  require(type.has_value(), "{} has voxels of a type that is not known here.", path.string());
  stored.type = *type;
  const auto components = line.size() >= 4 ? parseNumber<int>(line[3]) : 1;
  require(components && *components >= 1 && *components <= 4, "{} does not say how many numbers a voxel has.",
          path.string());
  stored.components = *components;
}

// Reads one line; true when the voxels begin after it.
bool readLine(const std::vector<std::string_view>& line, const fs::path& path, StoredVolume& stored) {
  const std::string keyword = lowerCase(line[0]);
  Geometry& g = stored.geometry;
  if (keyword == "dataset") {
    require(line.size() == 2 && lowerCase(line[1]) == "structured_points",
            "{} does not hold a volume on a regular grid (STRUCTURED_POINTS).", path.string());
  } else if (keyword == "dimensions") {
    const glm::dvec3 dims = three(line, path);
    for (int a = 0; a < 3; ++a) {
      require(dims[a] >= 1 && dims[a] <= 65535,
              "{} says that it has {} voxels along one axis; 2 to 65535 are possible.", path.string(),
              dims[a]);
      g.dims[a] = int(dims[a]);
    }
  } else if (keyword == "origin") {
    g.origin = three(line, path);
  } else if (keyword == "spacing" || keyword == "aspect_ratio") {
    g.spacing = three(line, path);
    stored.spacingKnown = true;
  } else if (keyword == "scalars") {
    readScalars(line, path, stored);
  } else if (keyword == "lookup_table") {
    return true;
  } else {
    require(keyword == "point_data", "{} has a line \"{}\" that is not known here.", path.string(),
            line[0].substr(0, 20));
  }
  return false;
}

}  // namespace

StoredVolume readVtkHeader(const fs::path& path) {
  const std::string text = readHeaderText(path);
  HeaderLines lines(text);
  lines.next();  // the magic
  lines.next();  // a title: free text, which may name a patient
  StoredVolume stored;
  stored.format = "VTK";
  stored.spacingKnown = false;
  stored.dataFile = path;
  stored.bigEndian = true;
  const std::string encoding = lowerCase(trimmed(lines.next().value_or("")));
  require(encoding == "binary" || encoding == "ascii", "{} is not a complete VTK file; get a fresh copy.",
          path.string());
  stored.encoding = encoding == "binary" ? Encoding::raw : Encoding::text;
  while (const auto line = lines.next()) {
    const auto parts = words(*line);
    if (parts.empty()) continue;
    if (!readLine(parts, path, stored)) continue;
    stored.fileOffset = lines.position();
    return stored;
  }
  throw Error(fmt::format("{} ends within its header; get a fresh copy.", path.string()));
}

}  // namespace sonoskin
