#include "core/io/scanners/kretz_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "core/base/error.h"
#include "core/base/log.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr double kMillimetres = 1000;  // in a metre
constexpr std::size_t kMostAngles = 65535;

// The record of volume v, or the grey one's where v has none.
KretzTag ownTag(const KretzRecords& records, std::uint16_t group, std::uint16_t element, int v) {
  const KretzTag own = kretzTag(group, element, v);
  return records.has(own) ? own : kretzTag(group, element);
}

// Angles count from a right angle, as SlicerHeart has them; tables around another direction are taken from their own middle,
// as plooney/kretz does with all. Both are the same for symmetric tables.
std::vector<double> fromMiddle(std::vector<double> angles, const fs::path& path) {
  require(std::all_of(angles.begin(), angles.end(), [](double a) { return std::isfinite(a); }),
          "{} has angles of beams that are no numbers; get a fresh copy.", path.string());
  constexpr double kRight = glm::half_pi<double>(), kAlmost = 0.999 * kRight, kSymmetric = 1e-3;
  const double own = 0.5 * (angles.front() + angles.back());
  const bool around =
      std::all_of(angles.begin(), angles.end(), [](double a) { return std::abs(a - kRight) < kAlmost; });
  if (!around)
    log(LogLevel::warning,
        "The angles of the beams are not around a right angle; their middle is assumed to "
        "be straight ahead.");
  else if (std::abs(own - kRight) > kSymmetric)
    log(LogLevel::warning,
        "The beams lie to one side of straight ahead by their angles, which are assumed to count from a "
        "right "
        "angle.");
  for (double& angle : angles) angle -= around ? kRight : own;
  return angles;
}

double sampleDistance(const KretzRecords& records, int v) {
  const auto metres = records.valueOf(ownTag(records, 0xC100, 0x0001, v));
  require(metres && std::isfinite(*metres) && *metres > 0,
          "{} does not say how far apart its samples are; save it again, or export it as DICOM.",
          records.path().string());
  return kMillimetres * *metres;
}

double offset(const KretzRecords& records, std::uint16_t element, int v) {
  const auto samples = records.valueOf(ownTag(records, 0xC200, element, v));
  require(samples && std::isfinite(*samples),
          "{} does not say where its beams begin; save it again, or export it as DICOM.",
          records.path().string());
  return *samples;
}

SweptGrid gridOf(const KretzRecords& records, int v, const glm::ivec3& dims) {
  SweptGrid grid;
  grid.samples = dims.x;
  grid.sampleDistance = sampleDistance(records, v);
  grid.firstRadius = offset(records, 0x0001, v) * grid.sampleDistance;
  grid.axisDepth = -offset(records, 0x0002, v) * grid.sampleDistance;
  grid.sweep = records.valuesOf(ownTag(records, 0xC300, 0x0001, v), kMostAngles);
  grid.fan = records.valuesOf(ownTag(records, 0xC300, 0x0002, v), kMostAngles);
  const fs::path& path = records.path();
  require(grid.fan.size() == std::size_t(dims.y) && grid.sweep.size() == std::size_t(dims.z),
          "{} has {} x {} beams, but the angles of {} x {}; get a fresh copy.", path.string(), dims.y, dims.z,
          grid.fan.size(), grid.sweep.size());
  grid.fan = fromMiddle(std::move(grid.fan), path);
  grid.sweep = fromMiddle(std::move(grid.sweep), path);
  return grid;
}

// No source knows for certain which record is the edge of Cartesian voxels: two that differ are told.
void setCartesian(const KretzRecords& records, int v, StoredVolume& stored) {
  const auto millimetres = records.valueOf(ownTag(records, 0x0010, 0x0022, v));
  const auto metres = records.valueOf(ownTag(records, 0xC100, 0x0001, v));
  stored.spacingKnown = millimetres || metres;
  if (!stored.spacingKnown) return;
  const double edge = millimetres ? *millimetres : kMillimetres * *metres;
  stored.geometry.spacing = glm::dvec3(edge);
  if (millimetres && metres && !(std::abs(kMillimetres * *metres - edge) <= 0.01 * std::abs(edge)))
    log(LogLevel::warning,
        fmt::format("The file gives {:g} and {:g} mm as the edge of its voxels; the first is assumed.", edge,
                    kMillimetres * *metres));
}

// 0001,0100: bits 0F voxels, bits F0 samples of beams; where it contradicts the angles that are there, these hold.
void noteKind(const KretzRecords& records, bool toroidal) {
  const std::uint32_t kind = records.knownWholeOf(kretzTag(0x0001, 0x0100)).value_or(0);
  if (toroidal && (kind & 0x0F) && !(kind & 0xF0))
    log(LogLevel::warning,
        "The file says that it has voxels, but gives the angles of beams; samples of beams are assumed.");
  if (!toroidal && (kind & 0xF0) && !(kind & 0x0F))
    log(LogLevel::warning,
        "The file says that it has samples of beams, but gives no angles; voxels are assumed, and the shape "
        "may be wrong.");
}

}  // namespace

glm::ivec3 kretzDims(const KretzRecords& records, int v) {
  glm::ivec3 dims(0);
  for (int a = 0; a < 3; ++a) {
    const auto count = records.wholeOf(ownTag(records, 0xC000, std::uint16_t(a + 1), v));
    require(count && *count >= 2 && *count <= 65535,
            "{} does not say how many voxels it has along each axis, 2 or more; get a fresh copy.",
            records.path().string());
    dims[a] = int(*count);
  }
  return dims;
}

void describeKretz(const KretzRecords& records, int v, StoredVolume& stored) {
  stored.geometry.dims = kretzDims(records, v);
  const bool sweep = records.has(ownTag(records, 0xC300, 0x0001, v));
  const bool fan = records.has(ownTag(records, 0xC300, 0x0002, v));
  const fs::path& path = records.path();
  require(sweep == fan, "{} gives the angles of its beams in one direction alone; get a fresh copy.",
          path.string());
  noteKind(records, sweep);
  if (!sweep) return setCartesian(records, v, stored);
  SweptGrid grid = gridOf(records, v, stored.geometry.dims);
  const auto fault = gridFault(grid);
  require(!fault, "The beams of {} cannot be: {}; get a fresh copy.", path.string(), fault.value_or(""));
  stored.geometry.spacing = glm::dvec3(grid.sampleDistance);
  stored.grid = std::move(grid);
}

}  // namespace sonoskin
