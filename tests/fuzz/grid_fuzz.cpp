// Grids of samples, as a process that reads volumes may answer them, and their conversion to voxels.
#include "core/volume/scan_convert.h"

#include <cmath>

#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;

namespace {

std::vector<double> tableOf(fuzz::Numbers& numbers) {
  std::vector<double> table(std::size_t(numbers.between(0, 6)));
  for (double& value : table) value = numbers.next<double>();
  return table;
}

SampleGrid gridOf(fuzz::Numbers& numbers) {
  if (numbers.between(0, 2) == 0) {
    PyramidGrid grid;
    for (int a = 0; a < 3; ++a) grid.dims[a] = numbers.between(0, 9);
    for (double* length : {&grid.lateral, &grid.depth, &grid.aperture, &grid.growth})
      *length = numbers.next<double>();
    return grid;
  }
  SweptGrid grid;
  grid.samples = numbers.between(0, 9);
  grid.parallel = numbers.between(0, 1) == 1;
  for (double* length : {&grid.firstRadius, &grid.sampleDistance, &grid.axisDepth})
    *length = numbers.next<double>();
  grid.fan = tableOf(numbers);
  grid.sweep = tableOf(numbers);
  return grid;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers numbers({data, size});
  const SampleGrid grid = gridOf(numbers);
  if (gridFault(grid)) return 0;
  const Geometry voxels = voxelsOf(grid, 0, 20000);
  fuzz::claim(voxels.voxels() <= 60000, "no more voxels are chosen than there may be");
  Geometry own;
  own.dims = gridDims(grid);
  const ConvertedScan converted = convertScan(grid, Volume<float>(own, 1), voxels);
  for (std::size_t v = 0; v < voxels.voxels(); ++v) {
    const float value = converted.volume.data[v];
    fuzz::claim(converted.scanned.data[v] ? std::abs(value - 1) < 1e-3f : value == 0, "nothing leaks");
  }
  return 0;
}
