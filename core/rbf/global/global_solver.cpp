#include "core/rbf/global/global_solver.h"

#include "core/rbf/global/global_fgmres.h"

namespace sonoskin {

GlobalSolution solveGlobal(const GlobalSystem& system, const Eigen::VectorXd& values,
                           const Eigen::VectorXd& start, const SolverOptions& options,
                           const Progress& progress) {
  const PolynomialSpace polynomials(system.sites, system.degree);
  const SchwarzPreconditioner schwarz(system, polynomials, options.schwarz, progress.part(0, 0.2));
  const Progress inner = progress.cancelOnly();
  const auto product = [&](const Eigen::VectorXd& w) {
    return Eigen::VectorXd(kernelProduct(system.kernel, system.sites, w, inner) + system.nugget * w);
  };
  GlobalSolution result;
  result.weights = start.size() > 0 ? start : Eigen::VectorXd::Zero(values.size());
  polynomials.project(result.weights);
  Eigen::VectorXd right = values;
  if (start.size() > 0) right -= product(result.weights);
  polynomials.project(right);

  const FgmresResult found = fgmres(
      [&](const Eigen::VectorXd& w) {
        Eigen::VectorXd image = product(w);
        polynomials.project(image);
        return image;
      },
      [&](const Eigen::VectorXd& r) { return schwarz.apply(r, inner); }, right,
      {options.tolerance * values.norm(), options.mostSteps}, progress.part(0.2, 0.95));
  result.steps = found.steps;
  result.weights += found.x;

  Eigen::VectorXd left = values - product(result.weights);
  result.polynomial = polynomials.fit(left);
  result.relativeResidual = values.norm() > 0 ? left.norm() / values.norm() : 0;
  left += system.nugget * result.weights;
  result.largestResidual = left.lpNorm<Eigen::Infinity>();
  progress.update(1);
  return result;
}

}  // namespace sonoskin
