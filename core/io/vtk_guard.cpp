// Headers of VTK legacy files with structured points (vtk.org/wp-content/uploads/2015/04/file-formats.pdf).
#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/io/declared_data.h"
#include "core/io/header_text.h"
#include "core/io/stored_volume.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Words = std::vector<std::string_view>;

void checkNumbers(const Words& line, const fs::path& path) {
  require(line.size() == 4 && std::all_of(line.begin() + 1, line.end(), isFinite),
          "The line {} in {} is not three numbers; get a fresh copy.", line[0].substr(0, 20), path.string());
}

void readScalars(const Words& line, const fs::path& path, DeclaredData& data) {
  const auto type = line.size() >= 3 ? numberTypeOf(lowerCase(line[2])) : std::nullopt;
  require(type.has_value(),
          "{} has numbers of a type that is not known here; save it with whole numbers or as float.",
          path.string());
  data.bytesPerNumber = numberTypeBytes(*type);
  const auto components = line.size() >= 4 ? parseNumber<int>(line[3]) : 1;
  require(components && *components >= 1 && *components <= 4,
          "{} does not say how many numbers a voxel has; get a fresh copy.", path.string());
  data.components = *components;
}

void readLine(const std::string& keyword, const Words& line, const fs::path& path, DeclaredData& data) {
  if (keyword == "dataset") {
    require(line.size() == 2 && lowerCase(line[1]) == "structured_points",
            "{} does not hold a volume on a regular grid (STRUCTURED_POINTS); resample it to one.",
            path.string());
  } else if (keyword == "dimensions") {
    checkNumbers(line, path);
    for (std::size_t a = 1; a < 4; ++a) data.sizes.push_back(parseNumber<int>(line[a]).value_or(0));
  } else if (keyword == "origin" || keyword == "spacing" || keyword == "aspect_ratio") {
    checkNumbers(line, path);
    data.spacingKnown = data.spacingKnown || keyword != "origin";
  } else if (keyword == "scalars") {
    readScalars(line, path, data);
  } else {
    require(keyword == "point_data", "{} has a line \"{}\" that is not known here; save it again without.",
            path.string(), line[0].substr(0, 20));
  }
}

}  // namespace

DeclaredData vtkData(const fs::path& path) {
  const std::string text = readHeaderText(path);
  HeaderLines lines(text, path);
  lines.next();  // the magic
  lines.next();  // a title: free text, which may name a patient
  DeclaredData data;
  data.file = path;
  const std::string encoding = lowerCase(trimmed(lines.next().value_or("")));
  require(encoding == "binary" || encoding == "ascii", "{} is not a complete VTK file; get a fresh copy.",
          path.string());
  data.encoding = encoding == "binary" ? Encoding::raw : Encoding::text;
  std::set<std::string> seen;
  while (const auto line = lines.next()) {
    const Words parts = words(*line);
    if (parts.empty()) continue;
    const std::string keyword = lowerCase(parts[0]);
    require(seen.insert(keyword).second, "{} has two lines {}; get a fresh copy.", path.string(),
            parts[0].substr(0, 20));
    if (keyword != "lookup_table") {
      readLine(keyword, parts, path, data);
      continue;
    }
    require(seen.contains("dimensions") && seen.contains("scalars"),
            "{} is not a complete VTK file; get a fresh copy.", path.string());
    data.offset = lines.position();
    return data;
  }
  throw Error(fmt::format("{} ends within its header; get a fresh copy.", path.string()));
}

}  // namespace sonoskin
