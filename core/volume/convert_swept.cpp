#include "core/volume/convert_swept.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

// So many entries lie between the two nearest beams, of an even table; uneven ones have more, up to a size that the first
// cache holds.
constexpr double kEntriesPerBeam = 16;
constexpr double kMostEntries = 6144;

double acrossOf(const SweptGrid& grid, double t) { return grid.parallel ? t : std::tan(t); }

int entriesFor(const SweptGrid& grid) {
  double nearest = std::abs(grid.fan.back() - grid.fan.front());
  const double width = nearest;
  for (std::size_t j = 1; j < grid.fan.size(); ++j)
    nearest = std::min(nearest, std::abs(grid.fan[j] - grid.fan[j - 1]));
  return int(std::clamp(kEntriesPerBeam * width / nearest, 2.0, kMostEntries)) + 1;
}

}  // namespace

FanTable::FanTable(const SweptGrid& grid) : beams_(std::size_t(entriesFor(grid))) {
  const auto [first, last] = std::minmax(grid.fan.front(), grid.fan.back());
  const double low = acrossOf(grid, first), high = acrossOf(grid, last);
  const double step = (high - low) / double(beams_.size() - 1);
  for (std::size_t e = 0; e < beams_.size(); ++e) {
    const double across = low + double(e) * step;
    const double t = std::clamp(grid.parallel ? across : std::atan(across), first, last);
    beams_[e] = float(tableIndex(grid.fan, t).value_or(0));
  }
  lowest_ = float(low);
  highest_ = float(high);
  perEntry_ = float(1 / step);
}

SweptConverter::SweptConverter(const SweptGrid& grid, const LargeArray<float>& samples,
                               const Geometry& geometry)
    : grid_(grid), samples_(samples.data()), geometry_(geometry), fan_(grid) {}

void SweptConverter::fillSlice(int k, ConvertedScan& converted) const {
  for (int j = 0; j < geometry_.dims.y; ++j) {
    float* values = &converted.volume.at(0, j, k);
    std::uint8_t* scanned = &converted.scanned.at(0, j, k);
    std::fill_n(values, geometry_.dims.x, 0.0f);
    std::fill_n(scanned, geometry_.dims.x, std::uint8_t(0));
    const glm::dvec3 start = geometry_.toWorld({0, j, k});
    const double behind = start.z - grid_.axisDepth;
    if (!(behind > 0)) continue;
    const auto picture = tableIndex(grid_.sweep, std::atan2(-start.y, behind));
    const double depth = std::hypot(start.y, behind) + grid_.axisDepth;
    if (picture && (depth > 0 || grid_.parallel)) fillRow({float(depth), float(*picture)}, values, scanned);
  }
}

void SweptConverter::fillRow(const Row& row, float* values, std::uint8_t* scanned) const {
  const float scale = grid_.parallel ? 1 : 1 / row.depth, squared = row.depth * row.depth;
  const float first = float(grid_.firstRadius), perSample = float(1 / grid_.sampleDistance);
  const float last = float(grid_.samples - 1);
  const float origin = float(geometry_.origin.x), edge = float(geometry_.spacing.x);
  const auto voxelAt = [&](float across) { return (across / scale - origin) / edge; };
  const int from = int(std::clamp(voxelAt(fan_.lowest()), 0.0f, float(geometry_.dims.x)));
  const int to = int(std::clamp(voxelAt(fan_.highest()) + 1, 0.0f, float(geometry_.dims.x)));
  for (int i = from; i < to; ++i) {
    const float x = origin + float(i) * edge, across = x * scale;
    const float radius = grid_.parallel ? row.depth : std::sqrt(x * x + squared);
    const float sample = (radius - first) * perSample;
    if (!(sample >= 0 && sample <= last && across >= fan_.lowest() && across <= fan_.highest())) continue;
    values[i] = at(sample, fan_.beamAt(across), row.picture);
    scanned[i] = 1;
  }
}

float SweptConverter::at(float sample, float beam, float picture) const {
  const int beams = int(grid_.fan.size());
  const int i = std::min(int(sample), grid_.samples - 2), j = std::min(int(beam), beams - 2);
  const int k = std::min(int(picture), int(grid_.sweep.size()) - 2);
  const float ti = sample - float(i), tj = beam - float(j), tk = picture - float(k);
  const std::ptrdiff_t row = grid_.samples, plane = row * beams;
  const float* near = samples_ + k * plane + j * row + i;
  const auto alongBeam = [&](const float* v) { return v[0] + ti * (v[1] - v[0]); };
  const auto inPicture = [&](const float* v) {
    const float low = alongBeam(v);
    return low + tj * (alongBeam(v + row) - low);
  };
  const float low = inPicture(near);
  return low + tk * (inPicture(near + plane) - low);
}

}  // namespace sonoskin
