#include "core/rbf/global/global_fgmres.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

namespace sonoskin {
namespace {

// LeastSquares: min |β e_1 - H y| for a Hessenberg matrix H that grows by a column per step; Givens rotations keep
// it triangular.
class LeastSquares {
 public:
  LeastSquares(double beta, int mostSteps)
      : h_(Eigen::MatrixXd::Zero(mostSteps + 1, mostSteps)), g_(Eigen::VectorXd::Zero(mostSteps + 1)) {
    g_[0] = beta;
  }

  double& entry(int row, int column) { return h_(row, column); }
  // finish: rotates column k; returns the norm of the residual.
  double finish(int k) {
    for (int i = 0; i < k; ++i) h_.col(k).applyOnTheLeft(i, i + 1, rotations_[std::size_t(i)].adjoint());
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(h_(k, k), h_(k + 1, k));
    rotations_.push_back(rotation);
    h_.col(k).applyOnTheLeft(k, k + 1, rotation.adjoint());
    g_.applyOnTheLeft(k, k + 1, rotation.adjoint());
    return std::abs(g_[k + 1]);
  }
  Eigen::VectorXd solve(int steps) const {
    return h_.topLeftCorner(steps, steps).triangularView<Eigen::Upper>().solve(g_.head(steps));
  }

 private:
  Eigen::MatrixXd h_;
  Eigen::VectorXd g_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
};

// How far the residual has come on its way, which it goes by about the same factor in every step.
double fractionDone(double first, double now, double tolerance) {
  if (now <= tolerance || tolerance <= 0) return 1;
  return std::clamp(std::log(first / now) / std::log(first / tolerance), 0.0, 1.0);
}

}  // namespace

FgmresResult fgmres(const LinearMap& apply, const LinearMap& precondition, const Eigen::VectorXd& b,
                    const FgmresLimits& limits, const Progress& progress) {
  FgmresResult result{Eigen::VectorXd::Zero(b.size()), 0, b.norm()};
  const double beta = result.residual;
  if (beta <= limits.tolerance) return result;
  LeastSquares small(beta, limits.mostSteps);
  std::vector<Eigen::VectorXd> basis{b / beta}, directions;
  while (result.steps < limits.mostSteps && result.residual > limits.tolerance) {
    progress.update(fractionDone(beta, result.residual, limits.tolerance));
    const int k = result.steps++;
    directions.push_back(precondition(basis.back()));
    Eigen::VectorXd next = apply(directions.back());
    const double whole = next.norm();
    for (int i = 0; i <= k; ++i) {
      small.entry(i, k) = next.dot(basis[std::size_t(i)]);
      next -= small.entry(i, k) * basis[std::size_t(i)];
    }
    const double norm = next.norm();
    small.entry(k + 1, k) = norm;
    result.residual = small.finish(k);
    if (!(norm > 1e-14 * whole)) break;  // the space holds the solution
    basis.push_back(next / norm);
  }
  const Eigen::VectorXd y = small.solve(result.steps);
  for (int k = 0; k < result.steps; ++k) result.x += y[k] * directions[std::size_t(k)];
  progress.update(1);
  return result;
}

}  // namespace sonoskin
