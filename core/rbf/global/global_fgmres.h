#pragma once

#include <Eigen/Core>
#include <functional>

#include "core/base/progress.h"

namespace sonoskin {

// FgmresLimits: when to stop: |residual| <= tolerance, or after as many steps.
struct FgmresLimits {
  double tolerance = 0;
  int mostSteps = 100;
};

// FgmresResult: the solution, or what had been reached; `residual` is the norm of b - A x by the recursion.
struct FgmresResult {
  Eigen::VectorXd x;
  int steps = 0;
  double residual = 0;
};

// fgmres: solves A x = b by flexible generalised minimal residuals, without restart, from x = 0.    [Saad 1993]
//   apply          A times a vector
//   precondition   an approximate inverse of A times a vector
//   cost           one call of each per step; two vectors of memory per step
//   errors         Cancelled, looked at in every step
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
FgmresResult fgmres(const LinearMap& apply, const LinearMap& precondition, const Eigen::VectorXd& b,
                    const FgmresLimits& limits, const Progress& progress = {});

}  // namespace sonoskin
