#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

namespace sonoskin {

// parseMesh: what readMesh promises, in this process, whatever the file does to the libraries.
//   errors  as readMesh
Mesh parseMesh(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace sonoskin
