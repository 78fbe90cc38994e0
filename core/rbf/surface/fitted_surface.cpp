#include "core/rbf/surface/fitted_surface.h"

#include <memory>

#include "core/rbf/compact/csrbf_function.h"
#include "core/rbf/global/global_fit.h"
#include "core/rbf/global/global_function.h"

namespace sonoskin {

FittedSurface fitSurface(const SurfacePoints& points, const ReconstructionOptions& options,
                         const GlobalOptions& global, const Progress& progress) {
  if (options.method == ReconstructionMethod::global) {
    const auto model = std::make_shared<const GlobalRbf>(fitGlobal(points, global, progress));
    const auto diagonal = double(boundingBox(points.positions).diagonal());
    return {[model](float cell) { return globalFunction(model, cell); }, model->size(), model->bytes(),
            FitReport{model->report().rmsResidual / diagonal, {}}};
  }
  const auto model = std::make_shared<const CsrbfModel>(fitCsrbf(points, options, progress));
  return {[model](float cell) { return csrbfFunction(*model, cell); }, model->centres().size(),
          model->bytes(), model->report()};
}

}  // namespace sonoskin
