#include "core/phantom/phantom_geometry.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/phantom/scene_acoustics.h"
#include "core/phantom/scene_world.h"

namespace sonoskin {

Geometry phantomGeometry(const PhantomOptions& options) {
  const auto [i, j, k] = options.dims;
  require(std::min({i, j, k}) >= 16 && std::max({i, j, k}) <= 1024,
          "phantom.dims is {} x {} x {} voxels: each must lie between 16 and 1024", i, j, k);
  require(options.snr >= 0 && options.snr <= 60, "phantom.snr is {} dB: it must lie between 0 and 60",
          options.snr);
  require(options.shape >= 0 && options.shape <= 1000000,
          "phantom.shape is {}: it must lie between 0 and 1000000", options.shape);
  require(options.seed >= 0 && options.seed <= 1000000,
          "phantom.seed is {}: it must lie between 0 and 1000000", options.seed);
  Geometry geometry;
  geometry.dims = {i, j, k};
  geometry.spacing = kFieldOfView / glm::dvec3(geometry.dims);
  geometry.origin = 0.5 * geometry.spacing;
  return geometry;
}

double anatomySpacing(const Geometry& geometry) { return std::clamp(geometry.minSpacing() / 0.6, 0.5, 1.0); }

SectorGrid sceneSector(const PhantomOptions& options) {
  const SceneAcoustics a = sceneAcoustics(options.scene);
  SectorGrid s = phantomSector(phantomGeometry(options).spacing);
  const float step = std::max(s.elevationStep(), a.planes);
  if (a.elevationAngle > 0) s.elevationAngle = a.elevationAngle;
  if (a.elevationAngle > 0 || a.planes > 0) s.elevations = 1 + int(2 * s.elevationAngle / step);
  return s;
}

}  // namespace sonoskin
