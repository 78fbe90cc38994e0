// VTK legacy files with one grid ("VTK File Formats", simple legacy formats; what VTK 9 adds to them).
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/header_text.h"
#include "core/io/headers/axis_roles.h"
#include "core/io/headers/declared_data.h"
#include "core/io/headers/vtk_attributes.h"
#include "core/io/headers/vtk_text.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

using Words = std::vector<std::string_view>;

// Grid: what stands before the attributes. Places along axes that are given one by one, evenly spaced.
struct Grid {
  bool rectilinear = false, sized = false, spaced = false;
  glm::ivec3 points{0};
  glm::dvec3 spacing{1}, origin{0};
};

glm::dvec3 threeNumbers(const Words& line, const fs::path& path) {
  const bool sound = line.size() == 4 && std::all_of(line.begin() + 1, line.end(), isFinite);
  require(sound, "The line {} in {} is not three numbers; get a fresh copy.", line[0].substr(0, 20),
          path.string());
  return {*parseNumber<double>(line[1]), *parseNumber<double>(line[2]), *parseNumber<double>(line[3])};
}

void readDataset(const Words& line, Grid& grid, const fs::path& path) {
  const std::string kind = line.size() == 2 ? lowerCase(line[1]) : "";
  grid.rectilinear = kind == "rectilinear_grid";
  require(kind == "structured_points" || grid.rectilinear,
          "{} does not hold a volume on a regular grid (STRUCTURED_POINTS); resample it to one.",
          path.string());
}

void readCoordinates(const Words& line, int axis, VtkText& text, Grid& grid, const fs::path& path) {
  const int count = line.size() == 3 ? parseNumber<int>(line[1]).value_or(0) : 0;
  const auto type = line.size() == 3 ? numberTypeOf(lowerCase(line[2])) : std::nullopt;
  require(grid.sized && type && count == grid.points[axis] && count >= 1,
          "The line {} in {} does not fit its DIMENSIONS; get a fresh copy.", line[0].substr(0, 20),
          path.string());
  const std::vector<double> at = text.numbers(*type, std::uint64_t(count));
  const double step = at.size() > 1 ? (at.back() - at.front()) / double(at.size() - 1) : 1;
  for (std::size_t n = 0; n < at.size(); ++n)
    require(std::abs(at[n] - at.front() - step * double(n)) <= 1e-3 * std::abs(step),
            "The planes of the grid in {} are not evenly spaced; resample it to STRUCTURED_POINTS.",
            path.string());
  grid.origin[axis] = at.front();
  grid.spacing[axis] = step;
  grid.spaced = true;
}

int coordinateAxis(const std::string& keyword) {
  return keyword == "x_coordinates"   ? 0
         : keyword == "y_coordinates" ? 1
         : keyword == "z_coordinates" ? 2
                                      : -1;
}

void readLine(const std::string& keyword, const Words& line, VtkText& text, Grid& grid,
              const fs::path& path) {
  if (keyword == "dataset") {
    readDataset(line, grid, path);
  } else if (keyword == "dimensions") {
    const glm::dvec3 sizes = threeNumbers(line, path);
    require(!grid.sized, "{} has two lines DIMENSIONS; get a fresh copy.", path.string());
    for (int a = 0; a < 3; ++a) grid.points[a] = int(std::clamp(sizes[a], -1.0, 1e6));
    grid.sized = true;
  } else if (keyword == "origin") {
    grid.origin = threeNumbers(line, path);
  } else if (keyword == "spacing" || keyword == "aspect_ratio") {
    grid.spacing = threeNumbers(line, path);
    grid.spaced = true;
  } else if (const int axis = coordinateAxis(keyword); axis >= 0 && grid.rectilinear) {
    readCoordinates(line, axis, text, grid, path);
  } else if (keyword == "field") {
    skipVtkField(line, text, path);
  } else {
    require(keyword == "metadata",
            "{} has a line before its POINT_DATA that is not known here; save it again without.",
            path.string());
    skipVtkMetadata(text);
  }
}

// To the line that the attributes begin with.
std::optional<std::string> readGrid(VtkText& text, Grid& grid, const fs::path& path) {
  while (auto line = text.line()) {
    const Words parts = words(*line);
    const std::string keyword = lowerCase(parts[0]);
    if (keyword == "point_data" || keyword == "cell_data") return line;
    readLine(keyword, parts, text, grid, path);
  }
  return {};
}

void readEncoding(VtkText& text, const fs::path& path) {
  text.plainLine();  // the magic
  text.plainLine();  // a title: free text, which may name a patient
  const std::string encoding = lowerCase(text.line().value_or(""));
  require(encoding == "binary" || encoding == "ascii", "{} is not a complete VTK file; get a fresh copy.",
          path.string());
  text.binary = encoding == "binary";
}

// Voxels of cells lie between the points.
void place(const Grid& grid, const VtkArray& array, DeclaredData& data, const fs::path& path) {
  Geometry& g = data.stored.geometry;
  for (int a = 0; a < 3; ++a) {
    const double step = grid.spacing[a];
    require(!grid.rectilinear || step != 0,
            "The planes of the grid in {} lie in one place; correct the file.", path.string());
    g.spacing[a] = grid.rectilinear ? std::abs(step) : step;
    if (grid.rectilinear && step < 0) g.direction[a] = -g.direction[a];
    g.origin[a] = grid.origin[a] + (array.ofCells && grid.points[a] > 1 ? step / 2 : 0);
    data.sizes.push_back(array.ofCells ? std::max(1, grid.points[a] - 1) : grid.points[a]);
  }
  data.stored.spacingKnown = grid.spaced;
}

}  // namespace

DeclaredData vtkData(const fs::path& path) {
  VtkText text(path);
  readEncoding(text, path);
  Grid grid;
  const auto begins = readGrid(text, grid, path);
  require(grid.sized && begins, "{} ends within its header; get a fresh copy.", path.string());
  for (int a = 0; a < 3; ++a)
    require(grid.points[a] >= 1 && grid.points[a] <= 65536,
            "{} says that it has {} voxels along one axis; 2 to 65535 are possible.", path.string(),
            grid.points[a]);
  const VtkArray array = findVtkArray(*begins, grid.points, text, path);
  DeclaredData data;
  place(grid, array, data, path);
  data.type = data.stored.type = array.type;
  data.stored.components = array.components;
  setScale(data, array.slope, 0);
  assignAxes({AxisRole::space, AxisRole::space, AxisRole::space}, data, path);
  data.bigEndian = true;
  data.encoding = text.binary ? Encoding::raw : Encoding::text;
  data.parts = {{path, array.offset}};
  return data;
}

}  // namespace sonoskin
