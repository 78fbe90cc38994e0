#pragma once

#include "core/rbf/global/global_schwarz.h"

namespace sonoskin {

// GlobalSolution: of a global system.
struct GlobalSolution {
  Eigen::VectorXd weights;      // λ, with Σ λ q(x) = 0 for all polynomials q of the degree
  Eigen::VectorXd polynomial;   // coefficients of the monomials
  int steps = 0;                // of the solver
  double relativeResidual = 0;  // |f - (A + ρI) λ - Q p| / |f|
  double largestResidual = 0;   // the same without ρ λ, largest over the sites: what the function misses
};

// SolverOptions: of the iteration.
struct SolverOptions {
  double tolerance = 1e-4;  // relative residual
  int mostSteps = 100;
  SchwarzOptions schwarz;
};

// solveGlobal: λ and p of a global system, by FGMRES on the space where Qᵀλ = 0.
//   values   f at the sites
//   start    a first guess of λ, or empty; its polynomial part is taken out
//   cost     5 to 10 products for the biharmonic kernel, up to 30 for the triharmonic one
//   output   what was reached: look at relativeResidual
//   errors   Cancelled
//   threads  the result does not depend on their number
GlobalSolution solveGlobal(const GlobalSystem& system, const Eigen::VectorXd& values,
                           const Eigen::VectorXd& start, const SolverOptions& options,
                           const Progress& progress = {});

}  // namespace sonoskin
