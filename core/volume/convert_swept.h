#pragma once

#include <vector>

#include "core/volume/scan_convert.h"

namespace sonoskin {

// FanTable: the beam at a place across a fan, without an arc tangent: entries even in x / d (in x where beams are parallel),
// between which it is linear.
class FanTable {
 public:
  explicit FanTable(const SweptGrid& grid);

  // beamAt: in beams; `across` between lowest() and highest().
  float beamAt(float across) const {
    const float at = (across - lowest_) * perEntry_;
    const int entry = std::min(int(at), int(beams_.size()) - 2);
    const float low = beams_[std::size_t(entry)], high = beams_[std::size_t(entry) + 1];
    return low + (at - float(entry)) * (high - low);
  }
  float lowest() const { return lowest_; }
  float highest() const { return highest_; }

 private:
  float lowest_, highest_, perEntry_;
  std::vector<float> beams_;
};

// SweptConverter: of a swept grid. Depth and sweep angle depend on y and z alone, so that each row of voxels along x has one
// of either; along it remain a root and a look into the fan's table.
class SweptConverter {
 public:
  SweptConverter(const SweptGrid& grid, const LargeArray<float>& samples, const Geometry& geometry);

  // fillSlice: all voxels of slice k.
  void fillSlice(int k, ConvertedScan& converted) const;

 private:
  // Row: what is the same along a row.
  struct Row {
    float depth, picture;
  };
  void fillRow(const Row& row, float* values, std::uint8_t* scanned) const;
  // at: trilinear; sample, beam and picture within the grid.
  float at(float sample, float beam, float picture) const;

  const SweptGrid& grid_;
  const float* samples_;
  const Geometry& geometry_;
  FanTable fan_;
};

}  // namespace sonoskin
