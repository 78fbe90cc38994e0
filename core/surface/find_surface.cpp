#include "core/surface/find_surface.h"

#include "core/surface/clusters.h"
#include "core/surface/echo_offset.h"
#include "core/surface/first_hit.h"
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

// The surface voxels that are kept.
std::vector<SurfaceVoxel> findVoxels(const SurfaceInput& input, const SurfaceOptions& given,
                                     const Progress& progress) {
  const Geometry& geometry = input.classified.geometry;
  const SurfaceOptions options = scaledToStrongest(given, input.classified, progress.part(0, 0.1));
  const auto thinning = options.thinning == ThinningMethod::thesis ? thinByThesis : thin;
  std::vector<SurfaceVoxel> voxels =
      thinning(input.classified, input.lowPassed, input.frame, options, progress.part(0.1, 0.6));
  std::erase_if(voxels, [&](const SurfaceVoxel& v) { return !input.frame.region.contains(v.voxel); });
  voxels = dropWeakClusters(voxels, geometry, options);
  progress.update(0.7);
  if (options.firstHit > 0) {
    const FluidLevels levels = findFluidLevels(input.lowPassed, input.frame.view, input.isoValue);
    voxels = keepFirstHits(voxels, input.lowPassed, input.frame, levels, options.firstHit,
                           progress.part(0.7, 0.9));
    voxels = dropWeakClusters(voxels, geometry, options);  // of what is left
  }
  progress.update(0.9);
  return dropLooseLobes(voxels, geometry, options);
}

}  // namespace

FoundSurface findSurface(const SurfaceInput& input, const SurfaceOptions& options, const Progress& progress) {
  FoundSurface found;
  found.voxels = findVoxels(input, options, progress.part(0, 0.8));
  found.points = extractSurfacePoints(found.voxels, input.lowPassed, progress.part(0.8, 0.9));
  if (options.offsetCorrection) {
    found.echoOffset = echoOffset(found.points, input.recorded, progress.part(0.9, 1));
    moveInward(found.points, found.echoOffset);
  }
  return found;
}

}  // namespace sonoskin
