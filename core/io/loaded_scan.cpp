#include "core/io/loaded_scan.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/available_memory.h"
#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/normalise.h"
#include "core/volume/scan_convert.h"
#include "core/volume/scan_size.h"

namespace sonoskin {
namespace {

// No more than there is memory for on the way to a mesh, and than the dimensions of a volume bear.
Geometry chooseVoxels(const SampleGrid& grid, double edge) {
  constexpr double kMostVoxels = 2147483648.0, kNone = 1e18;
  const double most = std::min(kMostVoxels, double(availableMemory()) / kBytesPerVoxel);
  const Geometry voxels = voxelsOf(grid, edge, most);
  if (double(voxels.voxels()) > most || glm::any(glm::greaterThan(voxels.dims, glm::ivec3(65535))))
    throw Error(
        fmt::format("Voxels of {} mm would be {} x {} x {}, more than there is memory for; give a larger "
                    "scan.voxel, or 0.",
                    edge, voxels.dims.x, voxels.dims.y, voxels.dims.z),
        Error::Kind::system);
  if (voxels.voxels() < voxelsOf(grid, edge, kNone).voxels())
    log(LogLevel::warning,
        "There is little memory: the scan is converted to larger voxels than it was sampled for.");
  return voxels;
}

void noteConversion(const SampleGrid& grid, const Geometry& voxels) {
  const glm::ivec3 samples = gridDims(grid);
  const glm::dvec3& edge = voxels.spacing;
  const bool cubes = edge.x == edge.y && edge.x == edge.z;
  log(LogLevel::info, fmt::format("A {} of {} x {} x {} samples was converted to voxels of {} mm.",
                                  gridName(grid), samples.x, samples.y, samples.z,
                                  cubes ? fmt::format("{:.4g}", edge.x)
                                        : fmt::format("{:.4g} x {:.4g} x {:.4g}", edge.x, edge.y, edge.z)));
}

// Takes the samples, which go away with it.
void convert(const SampleGrid& grid, Volume<float> samples, double edge, Scan& scan,
             const Progress& progress) {
  const Geometry voxels = chooseVoxels(grid, edge);
  ConvertedScan converted = convertScan(grid, samples, voxels, progress);
  scan.volume = std::make_shared<const Volume<float>>(std::move(converted.volume));
  scan.beam = gridBeam(grid);
  // Pictures of a pyramid were converted before, and have bounds of their own in them, which are found as in any volume.
  if (!std::holds_alternative<PyramidGrid>(grid))
    scan.mask = std::make_shared<const Volume<std::uint8_t>>(std::move(converted.scanned));
  noteConversion(grid, voxels);
}

void takeMask(std::vector<std::uint8_t> recorded, Scan& scan) {
  auto mask = Volume<std::uint8_t>::unset(scan.volume->geometry);
  std::copy(recorded.begin(), recorded.end(), mask.data.begin());
  scan.mask = std::make_shared<const Volume<std::uint8_t>>(std::move(mask));
}

}  // namespace

LoadedScan scanOf(LoadedVolume loaded, const ReadOptions& options, bool isScan, const Progress& progress) {
  StoredVolume& stored = loaded.stored;
  requireMemory(stored.geometry, kBytesToRead, availableMemory());
  NormalisedVolume normalised =
      normalise(stored, loaded.numbers, progress.part(0, stored.grid ? 0.3 : 1),
                isScan && !stored.grid);  // samples have no padding: their grid ends where they do
  std::vector<std::uint8_t>().swap(loaded.numbers);
  LoadedScan result;
  Scan& scan = result.scan;
  result.valueMin = normalised.valueMin;
  result.valueMax = normalised.valueMax;
  scan.originalMin = normalised.originalMin;
  scan.originalMax = normalised.originalMax;
  scan.originalType = numberTypeName(stored.type);
  scan.spacingKnown = stored.spacingKnown;
  scan.beam = stored.beam;
  scan.modality = stored.modality;
  scan.timeSteps = stored.timeSteps;
  scan.time = options.time;
  scan.stepSeconds = stored.stepSeconds;
  if (stored.grid)
    convert(*stored.grid, std::move(normalised.volume), options.voxel, scan, progress.part(0.3, 1));
  else
    scan.volume = std::make_shared<const Volume<float>>(std::move(normalised.volume));
  if (!loaded.mask.empty()) takeMask(std::move(loaded.mask), scan);
  scan.key = scanKey(*scan.volume, scan.beam);
  if (scan.mask) scan.key = maskedKey(scan.key, *scan.mask);
  return result;
}

}  // namespace sonoskin
