#include "core/phantom/sector_grid.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/phantom/scene_world.h"

namespace sonoskin {
namespace {

// SectorPosition: range (mm) and angles (rad) of a position relative to the apex.
struct SectorPosition {
  float range, lateral, elevation;
};

SectorPosition toSector(const glm::vec3& fromApex) {
  const float across = std::sqrt(fromApex.y * fromApex.y + fromApex.z * fromApex.z);
  return {glm::length(fromApex), std::atan2(fromApex.x, across), std::atan2(fromApex.z, fromApex.y)};
}

// One row of voxels along x: the elevation angle is the same for all of them.
class RowConverter {
 public:
  RowConverter(const SectorGrid& sector, const std::vector<float>& values)
      : s_(sector), values_(values.data()), perRange_(1 / s_.rangeStep), perLateral_(1 / s_.lateralStep()) {}

  void convert(const Geometry& g, int j, int k, float* out) const {
    const glm::vec3 start = glm::vec3(g.toWorld({0, j, k})) - s_.apex;
    const float across = std::sqrt(start.y * start.y + start.z * start.z);
    const float elevation = (std::atan2(start.z, start.y) + s_.elevationAngle) / s_.elevationStep();
    if (elevation < 0 || elevation > float(s_.elevations - 1)) return;
    const int e = std::min(int(elevation), s_.elevations - 2);
    for (int i = 0; i < g.dims.x; ++i) {
      const float x = start.x + float(i) * float(g.spacing.x);
      const float range = (std::sqrt(x * x + across * across) - s_.firstRange) * perRange_;
      const float lateral = (std::atan2(x, across) + s_.lateralAngle) * perLateral_;
      const bool inside =
          range >= 0 && range <= float(s_.ranges - 1) && lateral >= 0 && lateral <= float(s_.laterals - 1);
      if (inside) out[i] = interpolate({range, lateral, elevation}, e);
    }
  }

 private:
  float interpolate(const glm::vec3& position, int e) const {
    const int r = std::min(int(position.x), s_.ranges - 2), l = std::min(int(position.y), s_.laterals - 2);
    const glm::vec3 t = position - glm::vec3(r, l, e);
    const float* near = values_ + s_.row(l, e) + r;
    const float* far = near + s_.row(0, 1);
    const auto alongRange = [&](const float* v) { return v[0] + t.x * (v[1] - v[0]); };
    const auto inPlane = [&](const float* v) {
      return alongRange(v) + t.y * (alongRange(v + s_.ranges) - alongRange(v));
    };
    return inPlane(near) + t.z * (inPlane(far) - inPlane(near));
  }

  const SectorGrid& s_;
  const float* values_;
  float perRange_, perLateral_;
};

}  // namespace

glm::vec3 SectorGrid::beam(int j, int k) const {
  const float lateral = -lateralAngle + float(j) * lateralStep();
  const float elevation = -elevationAngle + float(k) * elevationStep();
  return {std::sin(lateral), std::cos(lateral) * std::cos(elevation),
          std::cos(lateral) * std::sin(elevation)};
}

bool SectorGrid::contains(const glm::vec3& world, float margin) const {
  const SectorPosition p = toSector(world - apex);
  const float angularMargin = margin / std::max(p.range, 1.f);
  return p.range >= firstRange + margin && p.range <= lastRange() - margin &&
         std::abs(p.lateral) <= lateralAngle - angularMargin &&
         std::abs(p.elevation) <= elevationAngle - angularMargin;
}

SectorGrid phantomSector(const glm::dvec3& voxelSpacing) {
  const auto count = [](int full, double coarser) {
    return std::max(24, int(full / std::clamp(coarser, 1.0, 10.0)));
  };
  SectorGrid s{};
  s.ranges = count(441, voxelSpacing.y / 0.3);
  s.laterals = count(280, voxelSpacing.x / 0.3);
  s.elevations = count(112, voxelSpacing.z / 0.9);
  s.firstRange = 45;
  s.rangeStep = 88.f / float(s.ranges - 1);
  s.lateralAngle = glm::radians(40.f);
  s.elevationAngle = glm::radians(31.f);
  s.apex = glm::vec3(0.5 * kFieldOfView.x, -45, 0.5 * kFieldOfView.z);
  return s;
}

Volume<float> scanConvert(const SectorGrid& sector, const std::vector<float>& values,
                          const Geometry& geometry, const Progress& progress) {
  Volume<float> out(geometry);
  const RowConverter converter(sector, values);
  parallelFor(
      std::ptrdiff_t(geometry.dims.y) * geometry.dims.z,
      [&](std::ptrdiff_t row) {
        const int j = int(row % geometry.dims.y), k = int(row / geometry.dims.y);
        converter.convert(geometry, j, k, &out.at(0, j, k));
      },
      progress);
  return out;
}

}  // namespace sonoskin
