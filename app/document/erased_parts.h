#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/hash.h"
#include "core/volume/erase_mask.h"
#include "core/volume/lasso.h"

namespace sonoskin {

// ErasedParts: what was erased of a volume, with the strokes that led there, so that they can be taken back. Painting
// touches the voxels of the brush alone; a stroke is kept as the voxels that it changed.
class ErasedParts {
 public:
  // reset: nothing is erased of a volume of this geometry, and there are no strokes.
  void reset(const Geometry& geometry);

  // paint: goes on with the stroke that endStroke() ends; whether anything changed.
  bool paint(const Brush& brush) { return paintWith(brush); }
  bool paint(const Lasso& lasso) { return paintWith(lasso); }
  // become: what is marked in another mask of the same dimensions, and nothing else, as one stroke.
  void become(const Volume<std::uint8_t>& marked);
  void clear();
  void endStroke();

  // strokes: how many count now; goTo: takes some back, or does them again. The next stroke forgets those taken back.
  std::size_t strokes() const { return done_; }
  bool hasStrokes() const { return !strokes_.empty(); }
  void goTo(std::size_t strokes);

  // key: of what is erased now; a zero key where nothing is.
  const Key& key() const { return key_; }
  std::size_t voxels() const { return voxels_; }
  const Volume<std::uint8_t>& mask() const { return mask_; }  // 0 or 1; no voxels before the first stroke
  // snapshot: a copy that stays as it is, for work in the background; null where nothing is erased.
  std::shared_ptr<const Volume<std::uint8_t>> snapshot();

 private:
  struct Stroke {
    VoxelRuns runs;
    Key key;  // after it
  };
  template <class Shape>
  bool paintWith(const Shape& shape);
  void add(const VoxelRuns& runs);
  void toggleAndCount(const VoxelRuns& runs);
  void makeMask();

  Geometry geometry_;
  Volume<std::uint8_t> mask_;
  std::vector<Stroke> strokes_;
  std::size_t done_ = 0, voxels_ = 0;
  bool open_ = false;  // the last stroke goes on
  Key key_, snapshotKey_;
  std::shared_ptr<const Volume<std::uint8_t>> snapshot_;
};

}  // namespace sonoskin
