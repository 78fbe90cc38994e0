#include "core/classification/classify.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/classification/slab_solver.h"
#include "core/classification/thesis_system.h"

namespace sonoskin {

Volume<float> classify(const Volume<float>& volume, const Smoothed& smoothed,
                       const ClassificationOptions& options, const Progress& progress) {
  if (options.formulation != Formulation::variational) return classifyThesis(volume, options, progress);
  Volume<float> result = solveInSlabs({volume, smoothed.lowPassed, options, smoothed.levels}, progress);
  clampToTarget(result, options);
  return result;
}

void clampToTarget(Volume<float>& u, const ClassificationOptions& options) {
  const std::size_t slice = u.geometry.index(0, 0, 1);
  const float target = float(options.target);
  parallelFor(u.geometry.dims.z, [&](std::ptrdiff_t k) {
    float* row = u.data.data() + std::size_t(k) * slice;
#pragma omp simd
    for (std::size_t i = 0; i < slice; ++i) row[i] = std::min(std::max(row[i], 0.0f), target);
  });
}

}  // namespace sonoskin
