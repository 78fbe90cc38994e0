#include "core/classification/classify.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/classification/data_term.h"
#include "core/classification/pcg.h"
#include "core/classification/thesis_system.h"
#include "core/volume/gaussian.h"

namespace sonoskin {

Smoothed smooth(const Volume<float>& volume, const ClassificationOptions& options, const Progress& progress) {
  const glm::ivec3 dims = volume.geometry.dims;
  require(glm::min(dims.x, glm::min(dims.y, dims.z)) >= 3,
          "the volume has {}x{}x{} voxels: surfaces need at least 3 along each axis", dims.x, dims.y, dims.z);
  Smoothed smoothed;
  smoothed.lowPassed = gaussianBlur(volume, options.lowPass, progress.part(0, 0.7));
  smoothed.directions = std::make_shared<const Directions>(
      cellDirections(smoothed.lowPassed, options.directionScale, progress.part(0.7, 1)));
  return smoothed;
}

Volume<float> classify(const Volume<float>& volume, const Smoothed& smoothed,
                       const ClassificationOptions& options, const Progress& progress) {
  if (options.formulation != Formulation::variational) return classifyThesis(volume, options, progress);
  const DataTerm term = dataTerm(volume, smoothed.lowPassed, options, progress.part(0, 0.1));
  const TangentialOperator tangential(smoothed.directions, absoluteBeta(options));
  Solution solution = solveClassification(tangential, term, options.tolerance, progress.part(0.1, 1));
  Volume<float> result;
  result.geometry = volume.geometry;
  result.data = std::move(solution.u);
  // The operator is no M-matrix: u overshoots its bounds by up to 2 %.
  const std::size_t slice = volume.geometry.index(0, 0, 1);
  parallelFor(volume.geometry.dims.z, [&](std::ptrdiff_t k) {
    float* u = result.data.data() + std::size_t(k) * slice;
    for (std::size_t i = 0; i < slice; ++i) u[i] = std::clamp(u[i], 0.0f, float(options.target));
  });
  return result;
}

}  // namespace sonoskin
