#pragma once

#include <filesystem>

#include "core/io/headers/declared_data.h"
#include "core/io/headers/nrrd_fields.h"

namespace sonoskin {

// placeNrrd: which axes of a NRRD are space, time and colour, and where its voxels lie.
//   input   data  its sizes and its type
//   output  data.spaceAxes, timeAxis, componentAxis, poses (empty); stored.geometry in mm and LPS,
//           spacingKnown, timeSteps, stepSeconds, components
//   errors  Error: what the fields about axes say is contradictory or not known here
void placeNrrd(const NrrdFields& nrrd, DeclaredData& data, const std::filesystem::path& path);

}  // namespace sonoskin
