#include "tests/benchmarks/accuracy/levels.h"

#include <cmath>

#include "core/base/parallel.h"
#include "core/phantom/phantom_geometry.h"
#include "core/phantom/phantom_model.h"
#include "core/phantom/sector_grid.h"

namespace sonoskin::accuracy {
namespace {

struct Statistics {
  double mean = 0, variance = 0;
};

Statistics statisticsOf(const Volume<float>& volume, const std::vector<std::size_t>& voxels) {
  double sum = 0, squares = 0;
  for (const std::size_t v : voxels) {
    const double value = double(volume.data[v]);
    sum += value, squares += value * value;
  }
  const double n = std::max(1.0, double(voxels.size())), mean = sum / n;
  return {mean, squares / n - mean * mean};
}

}  // namespace

const std::vector<Level>& noiseLevels() {
  static const std::vector<Level> levels{{"A", 20}, {"B", 18.5}, {"C", 13}, {"D", 11}, {"E", 8}};
  return levels;
}

ContrastMeter::ContrastMeter(const PhantomOptions& options) {
  const Geometry g = phantomGeometry(options);
  const PhantomModel model(options);
  const SectorGrid sector = phantomSector(g.spacing);
  std::vector<std::vector<std::size_t>> skin(std::size_t(g.dims.z)), fluid(std::size_t(g.dims.z));
  parallelFor(g.dims.z, [&](std::ptrdiff_t k) {
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = (j + int(k)) % 4; i < g.dims.x; i += 4) {  // every fourth voxel is enough
        const glm::dvec3 p = g.toWorld({i, j, k});
        if (p.y > 45 || !sector.contains(glm::vec3(p), 4)) continue;
        const double d = model.skin(p);
        const glm::dvec3 beam = glm::normalize(p - glm::dvec3(sector.apex));
        if (std::abs(d + 0.45) < 0.45) {
          if (model.skin(p - 0.2 * beam) - d > 0.14) skin[std::size_t(k)].push_back(g.index(i, j, int(k)));
        } else if (d > 3 && p.y < 35 && model.other(p) > 3) {
          fluid[std::size_t(k)].push_back(g.index(i, j, int(k)));
        }
      }
  });
  for (const auto& slice : skin) skin_.insert(skin_.end(), slice.begin(), slice.end());
  for (const auto& slice : fluid) fluid_.insert(fluid_.end(), slice.begin(), slice.end());
}

double ContrastMeter::measure(const Volume<float>& volume) const {
  const Statistics skin = statisticsOf(volume, skin_), fluid = statisticsOf(volume, fluid_);
  return (skin.mean - fluid.mean) / std::sqrt(std::max(1e-12, 0.5 * (skin.variance + fluid.variance)));
}

}  // namespace sonoskin::accuracy
