#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/classification/iso_value.h"
#include "core/surface/clusters.h"
#include "core/volume/gaussian.h"
#include "core/volume/sample.h"
#include "tests/benchmarks/accuracy/methods.h"
#include "tests/benchmarks/accuracy/rival_support.h"

namespace sonoskin::accuracy {
namespace {

// A Gaussian and the maxima of its gradient: an edge detector in its simplest form.
Finding gaussianEdges(const Scan& scan, const Parameters& parameters) {
  constexpr double kSigma = 3, kThreshold = 0.035;
  const Volume<float> low = gaussianBlur(*scan.volume, kSigma);
  const Volume<float> magnitude = gradientMagnitude(low);
  const SurfaceOptions options = rivalOptions(parameters, low.geometry, kThreshold);
  return {finishRival(thin(magnitude, low, frameOf(scan, parameters), options), low, options)};
}

// Where v~ passes the iso-value within half a voxel of its centre, rising along the gradient.
void contourVoxel(const Volume<float>& low, float iso, float least, const glm::ivec3& voxel,
                  const ScanFrame& frame, const SurfaceOptions& options, std::vector<SurfaceVoxel>& found) {
  const Geometry& g = low.geometry;
  const glm::vec3 axisScale = g.axisScale();
  const glm::vec3 gradient = gradientAt(low, axisScale, g.index(voxel.x, voxel.y, voxel.z));
  const float length = glm::length(gradient);
  if (length <= least) return;
  glm::vec3 step = gradient * axisScale;
  step /= std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)});
  const glm::vec3 here(voxel);
  const float before = sampleTrilinear(low, here - 0.5f * step),
              after = sampleTrilinear(low, here + 0.5f * step);
  if (!(before < iso && after >= iso) || !accepts(frame, options, g, voxel, gradient)) return;
  found.push_back({voxel, here + step * ((iso - before) / (after - before) - 0.5f), std::min(1.f, length)});
}

// The surface v~ = v_iso, where it is steep enough.
Finding isoContour(const Scan& scan, const Parameters& parameters) {
  constexpr double kSigma = 1, kThreshold = 0.04;
  const Volume<float> low = gaussianBlur(*scan.volume, kSigma);
  const Geometry& g = low.geometry;
  const SurfaceOptions options = rivalOptions(parameters, g, kThreshold);
  const ScanFrame frame = frameOf(scan, parameters);
  const float given = float(parameters.classification.isoValue);
  const float iso = given > 0 ? given
                              : proposeLevels(gaussianBlur(*scan.volume, parameters.classification.lowPass),
                                              frame.view, frame.beam)
                                    .iso(parameters.classification.isoShare);
  std::vector<std::vector<SurfaceVoxel>> perSlice(std::size_t(g.dims.z));
  parallelFor(g.dims.z - 2, [&](std::ptrdiff_t inner) {
    const int k = int(inner) + 1;
    for (int j = 1; j < g.dims.y - 1; ++j)
      for (int i = 1; i < g.dims.x - 1; ++i)
        if (std::abs(low.at(i, j, k) - iso) < 0.5f)
          contourVoxel(low, iso, float(kThreshold), {i, j, k}, frame, options, perSlice[std::size_t(k)]);
  });
  std::vector<SurfaceVoxel> voxels;
  for (const auto& slice : perSlice) voxels.insert(voxels.end(), slice.begin(), slice.end());
  return {finishRival(voxels, low, options), double(iso)};
}

}  // namespace

ScanFrame frameOf(const Scan& scan, const Parameters& parameters) {
  const Beam beam = beamOf(scan, parameters.scan);
  return {beam, findFieldOfView(*scan.volume, beam)};
}

SurfaceOptions rivalOptions(const Parameters& parameters, const Geometry& geometry, double threshold) {
  constexpr double kFewestVoxels = 100;
  SurfaceOptions options = parameters.surface;
  const glm::dvec3& s = geometry.spacing;
  options.threshold = threshold;
  options.strongThreshold = 0;
  options.strongShare = 0;
  options.minClusterArea = kFewestVoxels * std::pow(s.x * s.y * s.z, 2.0 / 3.0);
  return options;
}

Volume<float> gradientMagnitude(const Volume<float>& volume) {
  const Geometry& g = volume.geometry;
  Volume<float> magnitude(g);
  const glm::vec3 axisScale = g.axisScale();
  parallelFor(g.dims.z - 2, [&](std::ptrdiff_t inner) {
    for (int j = 1; j < g.dims.y - 1; ++j)
      for (int i = 1; i < g.dims.x - 1; ++i) {
        const std::size_t index = g.index(i, j, int(inner) + 1);
        magnitude.data[index] = glm::length(gradientAt(volume, axisScale, index));
      }
  });
  return magnitude;
}

SurfacePoints finishRival(const std::vector<SurfaceVoxel>& voxels, const Volume<float>& lowPassed,
                          const SurfaceOptions& options) {
  return extractSurfacePoints(dropWeakClusters(voxels, lowPassed.geometry, options), lowPassed);
}

bool accepts(const ScanFrame& frame, const SurfaceOptions& options, const Geometry& g,
             const glm::ivec3& voxel, const glm::vec3& gradient) {
  const glm::vec3 position = glm::vec3(voxel) * glm::vec3(g.spacing);
  if (frame.view.depth(position) < float(options.borderMargin * g.minSpacing())) return false;
  const glm::dvec3 beam = frame.beam.directionAt(g.toWorld(glm::dvec3(voxel)));
  const float along = glm::dot(gradient, glm::vec3(glm::transpose(g.direction) * beam));
  return options.facing <= -1 || along > float(options.facing) * glm::length(gradient);
}

std::vector<Method> rivals() {
  return {{"gauss", "Gaussian (3 voxels), maxima of the gradient above 0.035", gaussianEdges},
          {"contour", "contour of a Gaussian (1 voxel) where the gradient is above 0.04", isoContour}};
}

}  // namespace sonoskin::accuracy
