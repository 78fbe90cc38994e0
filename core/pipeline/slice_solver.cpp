#include "core/pipeline/slice_solver.h"

#include <algorithm>
#include <cmath>

#include "core/volume/resample.h"

namespace sonoskin {
namespace {

// Voxels to each side of a slice: what lies a smoothing length away counts e times less in it, and this is about twice that.
int reachOf(const ClassificationOptions& options) {
  const double length = options.tangentialLength * std::sqrt(options.beta);
  return length < 2 ? 4 : length < 4 ? 7 : 10;  // few values: a slab is kept while beta is turned
}

// The grey at the edges as a part of the volume has it that begins at `first`.
GreyLevels levelsFrom(GreyLevels levels, const glm::ivec3& first) {
  if (!levels.edges) return levels;
  EdgeField edges = *levels.edges;
  edges.first += first;
  levels.edges = std::make_shared<const EdgeField>(std::move(edges));
  return levels;
}

// What is known of the volume, in the part that begins at `first`.
ClassifierInput cutOut(const ClassifierInput& whole, const glm::ivec3& first, const glm::ivec3& dims,
                       const Key& key) {
  const Prepared& from = *whole.prepared.value;
  auto volume = std::make_shared<const Volume<float>>(cropVolume(*whole.volume.value, first, dims));
  auto prepared = std::make_shared<const Prepared>(
      Prepared{{cropVolume(from.smoothed.lowPassed, first, dims), levelsFrom(from.smoothed.levels, first)},
               from.view,
               from.beam});
  return {{std::move(volume), key}, {std::move(prepared), key}};
}

}  // namespace

std::array<std::shared_ptr<const Volume<float>>, 3> SliceSolver::classify(
    const ClassifierInput& input, const ClassificationOptions& options, const glm::ivec3& voxel,
    const Progress& progress) {
  const glm::ivec3 whole = input.volume.value->geometry.dims,
                   at = glm::clamp(voxel, glm::ivec3(0), whole - 1);
  const int reach = reachOf(options);
  std::array<std::shared_ptr<const Volume<float>>, 3> slices;
  for (int axis = 0; axis < 3; ++axis) {
    Slab& slab = slabs_[std::size_t(axis)];
    const Key key = Hasher("slab").add(input.prepared.key).add(axis).add(at[axis]).add(reach).key();
    if (!(slab.key == key)) {
      slab = {};
      glm::ivec3 dims = whole;
      slab.first[axis] = std::max(at[axis] - reach, 0);
      dims[axis] = std::min(at[axis] + reach + 1, whole[axis]) - slab.first[axis];
      slab.input = cutOut(input, slab.first, dims, key);
      slab.key = key;
    }
    const auto u = slab.solver.classify(slab.input, options, progress.part(axis / 3.0, (axis + 1) / 3.0));
    glm::ivec3 first(0), dims = u->geometry.dims;
    first[axis] = at[axis] - slab.first[axis];
    dims[axis] = 1;
    slices[std::size_t(axis)] = std::make_shared<const Volume<float>>(cropVolume(*u, first, dims));
  }
  return slices;
}

}  // namespace sonoskin
