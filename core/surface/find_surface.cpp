#include "core/surface/find_surface.h"

#include <algorithm>
#include <iterator>

#include "core/surface/clusters.h"
#include "core/surface/edge_placement.h"
#include "core/surface/first_hit.h"
#include "core/surface/sides.h"
#include "core/surface/thesis_thinning.h"
#include "core/volume/histogram.h"

namespace sonoskin {
namespace {

// The options with thresholds on the scale of this volume.
SurfaceOptions scaledToStrongest(SurfaceOptions options, const Volume<float>& classified,
                                 const Progress& progress) {
  if (options.thresholdScale == ThresholdScale::one) return options;
  constexpr double kStrongestShare =
      0.998;  // in any scan of a face, more voxels than the rest lie on its skin
  const double strongest = quantile(classified, kStrongestShare, progress);
  options.threshold *= strongest;
  options.strongThreshold *= strongest;
  return options;
}

// Takes out what does not face the probe.
std::vector<SurfaceVoxel> takeSides(std::vector<SurfaceVoxel>& voxels, const SurfaceOptions& options) {
  std::vector<SurfaceVoxel> sides;
  const auto isSide = [&](const SurfaceVoxel& v) { return double(v.facing) <= options.facing; };
  std::ranges::copy_if(voxels, std::back_inserter(sides), isSide);
  std::erase_if(voxels, isSide);
  return sides;
}

// The surface voxels that are kept.
std::vector<SurfaceVoxel> findVoxels(const SurfaceInput& input, const SurfaceOptions& given,
                                     const Progress& progress) {
  const Geometry& geometry = input.classified.geometry;
  const SurfaceOptions options = scaledToStrongest(given, input.classified, progress.part(0, 0.1));
  const auto thinning = options.thinning == ThinningMethod::thesis ? thinByThesis : thin;
  std::vector<SurfaceVoxel> voxels =
      thinning(input.classified, input.lowPassed, input.frame, options, progress.part(0.1, 0.6));
  std::erase_if(voxels, [&](const SurfaceVoxel& v) { return !input.frame.region.contains(v.voxel); });
  const std::vector<SurfaceVoxel> sides = takeSides(voxels, options);
  voxels = dropWeakClusters(voxels, geometry, options);
  progress.update(0.7);
  const auto firstHits = [&](const std::vector<SurfaceVoxel>& all, const Progress& part) {
    const FluidLevels levels = findFluidLevels(input.lowPassed, input.frame.view, input.isoValue);
    return keepFirstHits(all, input.lowPassed, input.frame, levels, options.firstHit, part);
  };
  if (options.firstHit > 0) {
    voxels = firstHits(voxels, progress.part(0.7, 0.8));
    voxels = dropWeakClusters(voxels, geometry, options);  // of what is left
  }
  voxels = dropLooseLobes(voxels, geometry, options);
  voxels = growSides(voxels, sides, geometry, options.sides);
  if (options.sides > 0) voxels = dropBareSides(voxels, geometry, input.frame.beam);
  progress.update(0.9);
  return options.firstHit > 0 ? firstHits(voxels, progress.part(0.9, 1)) : voxels;
}

}  // namespace

FoundSurface findSurface(const SurfaceInput& input, const SurfaceOptions& options, const Progress& progress) {
  FoundSurface found;
  found.voxels = findVoxels(input, options, progress.part(0, 0.8));
  found.points = extractSurfacePoints(found.voxels, input.lowPassed, progress.part(0.8, 0.9));
  if (options.offsetCorrection)
    found.edge = placeOnEdges(found.points, input.recorded, options.skinDepth, progress.part(0.9, 1));
  return found;
}

}  // namespace sonoskin
