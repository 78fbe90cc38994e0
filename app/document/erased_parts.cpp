#include "app/document/erased_parts.h"

#include <utility>

namespace sonoskin {

void ErasedParts::reset(const Geometry& geometry) {
  *this = {};
  geometry_ = geometry;
}

void ErasedParts::makeMask() {
  if (mask_.data.empty()) mask_ = Volume<std::uint8_t>(geometry_);
}

template <class Shape>
bool ErasedParts::paintWith(const Shape& shape) {
  if (!shape.mark && voxels_ == 0) return false;
  makeMask();
  const VoxelRuns runs = sonoskin::paint(mask_, shape);
  for (const VoxelRun& run : runs) voxels_ = shape.mark ? voxels_ + run.count : voxels_ - run.count;
  add(runs);
  return !runs.empty();
}

template bool ErasedParts::paintWith(const Brush&);
template bool ErasedParts::paintWith(const Lasso&);

void ErasedParts::become(const Volume<std::uint8_t>& marked) {
  endStroke();
  makeMask();
  const VoxelRuns runs = differences(mask_, marked);
  toggleAndCount(runs);
  add(runs);
  endStroke();
}

void ErasedParts::clear() {
  if (voxels_ > 0) become(Volume<std::uint8_t>(geometry_));
}

// Notes what the stroke at hand has changed.
void ErasedParts::add(const VoxelRuns& runs) {
  if (runs.empty()) return;
  if (!open_) {
    strokes_.resize(done_);
    strokes_.emplace_back();
    open_ = true;
  }
  Hasher hasher("painted");
  hasher.add(key_);
  for (const VoxelRun& run : runs) hasher.add(run.first).add(run.count);
  key_ = voxels_ > 0 ? hasher.key() : Key{};
  Stroke& stroke = strokes_.back();
  stroke.runs.insert(stroke.runs.end(), runs.begin(), runs.end());
  stroke.key = key_;
}

void ErasedParts::endStroke() {
  if (std::exchange(open_, false)) done_ = strokes_.size();
}

void ErasedParts::toggleAndCount(const VoxelRuns& runs) {
  toggle(mask_, runs);
  for (const VoxelRun& run : runs)
    for (std::size_t v = run.first; v < run.first + run.count; ++v)
      voxels_ = mask_.data[v] ? voxels_ + 1 : voxels_ - 1;
}

void ErasedParts::goTo(std::size_t strokes) {
  endStroke();
  while (done_ > strokes) toggleAndCount(strokes_[--done_].runs);
  while (done_ < strokes && done_ < strokes_.size()) toggleAndCount(strokes_[done_++].runs);
  key_ = done_ > 0 ? strokes_[done_ - 1].key : Key{};
}

std::shared_ptr<const Volume<std::uint8_t>> ErasedParts::snapshot() {
  if (voxels_ == 0) return nullptr;
  if (!snapshot_ || !(snapshotKey_ == key_)) {
    snapshot_ = std::make_shared<const Volume<std::uint8_t>>(mask_);
    snapshotKey_ = key_;
  }
  return snapshot_;
}

}  // namespace sonoskin
