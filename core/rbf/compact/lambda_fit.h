#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/rbf/compact/centres.h"
#include "core/rbf/compact/lambda_system.h"

namespace sonoskin {

// FunctionForm: S = Σ (g_c + λ_c) φ_c, divided by Σ φ_c (normalised) or not (plain, as in the thesis). Both have the
// same zero set for the same λ, but the systems that λ solves differ.
enum class FunctionForm { normalised, plain };

// solveLambda: λ of (A + T_reg Dg) λ = b with Dg_ii = 1/(M σ_i²).                         [thesis 3.23 to 3.25]
//   method   conjugate gradients, Jacobi preconditioner, until |residual| <= 1e-4 |b|; A is symmetric and positive
//            semi-definite
//   errors   Cancelled
std::vector<double> solveLambda(const LambdaSystem& system, const std::vector<Centre>& centres,
                                double regularisation, const Progress& progress = {});

// fitLambda: sets the weights λ of the centres so that S is smallest at the points. Lowers the residual by
// following the noise: worth it on clean points only.
//   output   S(p_k) with the weights, mm, at the sorted points
//   errors   Cancelled
std::vector<float> fitLambda(const SortedPoints& points, double regularisation, CentreSelection& selection,
                             FunctionForm form = FunctionForm::normalised, const Progress& progress = {});

// globalError: E_global = (1/L) sqrt(Σ_k d_k S(p_k)² / Σ_k d_k)                                   [thesis 3.22]
//   values   S at the sorted points, mm
double globalError(const SortedPoints& points, const std::vector<float>& values);

// valuesAtPoints: S_0 at the sorted points in that form, mm.
std::vector<float> valuesAtPoints(const CentreSelection& selection, FunctionForm form);

}  // namespace sonoskin
