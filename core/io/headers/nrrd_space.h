#pragma once

#include <filesystem>
#include <glm/glm.hpp>

#include "core/io/headers/nrrd_fields.h"

namespace sonoskin {

// NrrdSpace: the world of a NRRD.
//   dimension  numbers of a vector; 0: the file has no vectors
//   toLps      what each of a vector's first three numbers is multiplied by: the sign that leads to LPS, and
//              its unit in mm
//   hasTime    the last number is time, of which one is `timeUnit` seconds; 0: not told
struct NrrdSpace {
  int dimension = 0;
  glm::dvec3 toLps{1};
  bool hasTime = false;
  double timeUnit = 0;

  // world: the mm of a vector's first three numbers, the third 0 where there are two.
  glm::dvec3 world(const std::vector<double>& vector) const;
};

// nrrdSpace: of the fields "space", "space dimension" and "space units".
//   errors  Error: a space or a dimension that is not known here
NrrdSpace nrrdSpace(const NrrdFields& nrrd, const std::filesystem::path& path);

}  // namespace sonoskin
