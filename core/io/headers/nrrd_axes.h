#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "core/io/headers/axis_roles.h"
#include "core/io/headers/nrrd_fields.h"

namespace sonoskin {

// NrrdAxis: what the per-axis fields of a NRRD say of one axis, as they say it; NaN and empty where they do
// not.
struct NrrdAxis {
  enum class Centre { unsaid, cell, node };
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double spacing = kNone, least = kNone, most = kNone;
  Centre centre = Centre::unsaid;
  std::string unit, kind;
  NrrdVector direction;
};

// nrrdAxes: of as many axes as the file has.
//   errors  Error: a field does not have one finite number, word or vector for each
std::vector<NrrdAxis> nrrdAxes(const NrrdFields& nrrd, std::size_t count, const std::filesystem::path& path);

// nrrdRoles: what each axis is: as its kind says, else by its direction, its unit, its place.
//   errors  Error: time or colour cannot be told from space
std::vector<AxisRole> nrrdRoles(const std::vector<NrrdAxis>& axes, const std::vector<std::int64_t>& sizes,
                                const std::filesystem::path& path);

}  // namespace sonoskin
