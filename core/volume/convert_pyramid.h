#pragma once

#include <vector>

#include "core/volume/scan_convert.h"

namespace sonoskin {

// PyramidConverter: of a pyramid grid. Each row of voxels along x lies between the same two rows of the same two pictures.
class PyramidConverter {
 public:
  PyramidConverter(const PyramidGrid& grid, const LargeArray<float>& samples, const Geometry& geometry);

  // fillSlice: all voxels of slice k.
  void fillSlice(int k, ConvertedScan& converted) const;

 private:
  // Place: between two samples of an axis; `sampled` is false outside of the grid.
  struct Place {
    int low = 0;
    float part = 0;
    bool sampled = false;
  };
  static Place placeIn(double cell, int cells);
  // mixRow: the samples of a row between rows and pictures.
  void mixRow(const Place& row, const Place& picture, std::vector<float>& mixed) const;

  const PyramidGrid& grid_;
  const float* samples_;
  const Geometry& geometry_;
  std::vector<Place> across_;  // of every voxel along x
};

}  // namespace sonoskin
