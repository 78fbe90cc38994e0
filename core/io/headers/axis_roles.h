#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/io/headers/declared_data.h"

namespace sonoskin {

// AxisRole: what an axis of a file means. list: a row of pictures or volumes, in time or not.
enum class AxisRole { unsaid, space, time, list, colour, vector, otherColour, one };

// roleOfKind: of a word of NRRD's "kinds", which MetaImages of PLUS have too.
//   output  unsaid for "???" and "none"; vector for all that is neither space, time nor grey nor colour
AxisRole roleOfKind(std::string_view kind);

// assignAxes: finds the axes of space, time and colour of a file.
//   input   roles  one for each of data.sizes
//           data   its sizes and its type
//           tracked  the header gives a place to many pictures: the last of three axes is a row of them,
//                    however it is called
//   output  data.spaceAxes, timeAxis, componentAxis; stored.geometry.dims, timeSteps and components; `poses`,
//           empty, where the file is a row of flat pictures
//   errors  Error: there are not three axes of space; numbers that are neither grey nor colour; two axes of
//           time
void assignAxes(std::vector<AxisRole> roles, DeclaredData& data, const std::filesystem::path& path,
                bool tracked = false);

}  // namespace sonoskin
