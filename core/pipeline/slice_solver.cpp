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

// Ten times that of the whole volume: what a slab does not see of the volume is wrong by more.
constexpr double kTolerance = 10 * LiveClassifier::kLiveTolerance;

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

std::shared_ptr<const Volume<float>> SliceSolver::classify(const ClassifierInput& input,
                                                           const ClassificationOptions& options,
                                                           const VolumeSlice& slice,
                                                           const Progress& progress) {
  const glm::ivec3 whole = input.volume.value->geometry.dims;
  const int axis = slice.axis, at = std::clamp(slice.at, 0, whole[axis] - 1), reach = reachOf(options);
  Slab& slab = slabs_[std::size_t(axis)];
  const Key key = Hasher("slab").add(input.prepared.key).add(axis).add(at).add(reach).key();
  if (!(slab.key == key)) {
    slab = {};
    glm::ivec3 dims = whole;
    slab.first[axis] = std::max(at - reach, 0);
    dims[axis] = std::min(at + reach + 1, whole[axis]) - slab.first[axis];
    slab.input = cutOut(input, slab.first, dims, key);
    slab.key = key;
  }
  ClassificationOptions rough = options;
  rough.tolerance = std::max(options.tolerance, kTolerance);
  const auto u = slab.solver.classify(slab.input, rough, progress);
  glm::ivec3 first(0), dims = u->geometry.dims;
  first[axis] = at - slab.first[axis];
  dims[axis] = 1;
  return std::make_shared<const Volume<float>>(cropVolume(*u, first, dims));
}

}  // namespace sonoskin
