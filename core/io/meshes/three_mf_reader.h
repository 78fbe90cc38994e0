#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// readThreeMf: what a 3MF file says is to be built: its items, with the objects that they are made of, in other parts of the
// file too, where their transforms put them.  [3MF Core Specification 1.3; Production Extension 1.1]
//   output  mm, whatever unit the file is in, in the file's axes; vertices at equal positions are one; supports are left out
//   errors  Error: damaged or incomplete; an object that is not there or holds itself; nothing to build; a required
//           extension that is not known here; Cancelled
Mesh readThreeMf(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
