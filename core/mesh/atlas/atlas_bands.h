#pragma once

#include "core/mesh/atlas/atlas.h"
#include "core/mesh/atlas/raster.h"

namespace sonoskin {

// AtlasBands: bands of rows of an atlas and the triangles that reach into each, so that bands are drawn at the same
// time and each in a fixed order.
class AtlasBands {
 public:
  static constexpr int kRows = 32;

  // corners   in the order in which they are drawn;   reach: how far around them is drawn, texels
  AtlasBands(const glm::ivec2& size, const std::vector<Corners>& corners, float reach = 0);

  int count() const { return int(start_.size()) - 1; }
  glm::ivec2 rows(int band) const { return {band * kRows, std::min((band + 1) * kRows, height_)}; }
  // The numbers of the triangles of a band, in order.
  const std::uint32_t* begin(int band) const { return items_.data() + start_[std::size_t(band)]; }
  const std::uint32_t* end(int band) const { return items_.data() + start_[std::size_t(band) + 1]; }

 private:
  int height_;
  std::vector<std::uint32_t> start_, items_;
};

}  // namespace sonoskin
