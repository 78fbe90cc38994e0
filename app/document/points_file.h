#pragma once

#include <filesystem>

#include "core/surface/surface_points.h"

namespace sonoskin {

// writePoints: places and normals as a PLY file without triangles, atomically; mm, LPS.
//   errors  Error (system): the file cannot be written
void writePoints(const std::filesystem::path& path, const SurfacePoints& points);

}  // namespace sonoskin
