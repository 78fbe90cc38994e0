#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/headers/vtk_text.h"

namespace sonoskin {

// VtkArray: numbers of each point or of each cell of a grid.
struct VtkArray {
  NumberType type = NumberType::uint8;
  int components = 1;
  std::uintmax_t offset = 0;  // of the numbers in the file
  bool ofCells = false;
  double slope = 1;  // to what the same numbers are in a binary file
};

// findVtkArray: the voxels among the attributes of a grid: its first scalars, of points before those of
// cells, or else the first array of a field that has one number or a colour for each.
//   input   line    the line POINT_DATA or CELL_DATA, which was read last
//           points  of the grid along each axis
//   errors  Error: there is none; counts that do not fit the grid; numbers of a type that is not known here
// Says how many others are left out.
VtkArray findVtkArray(const std::string& line, const glm::ivec3& points, VtkText& text,
                      const std::filesystem::path& path);

// skipVtkField: passes over a FIELD; skipVtkMetadata: over a METADATA block, to the empty line that ends it.
//   errors  Error: arrays of a type that is not known here; the file ends within
void skipVtkField(const std::vector<std::string_view>& line, VtkText& text,
                  const std::filesystem::path& path);
void skipVtkMetadata(VtkText& text);

}  // namespace sonoskin
