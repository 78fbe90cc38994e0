#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/progress.h"
#include "core/rbf/global/global_basis.h"
#include "core/rbf/global/global_sites.h"

namespace sonoskin {

using VectorRef = Eigen::Ref<const Eigen::VectorXd>;

// kernelProduct: (A w)_i = Σ_j w_j φ(|x_i - x_j|), every pair of sites evaluated once.
//   cost     N²/2 kernels; 1 G per second and core for the harmonic ones; 32 N doubles of scratch
//   errors   Cancelled
//   threads  the result does not depend on their number
Eigen::VectorXd kernelProduct(const RadialKernel& kernel, const Sites& sites, const VectorRef& weights,
                              const Progress& progress = {});

// kernelSums: Σ_j w_j φ(|t_i - x_j|) at other places t.
//   cost, errors, threads   as kernelProduct, T N kernels
Eigen::VectorXd kernelSums(const RadialKernel& kernel, const Sites& sites, const VectorRef& weights,
                           const Sites& targets, const Progress& progress = {});

// kernelGradients: Σ_j w_j ∇φ(|t_i - x_j|), likewise.
//   errors   Cancelled
std::vector<glm::dvec3> kernelGradients(const RadialKernel& kernel, const Sites& sites,
                                        const VectorRef& weights, const Sites& targets,
                                        const Progress& progress = {});

// kernelMatrix: A_ij = φ(|x_i - x_j|) among the sites.
Eigen::MatrixXd kernelMatrix(const RadialKernel& kernel, const Sites& sites);

}  // namespace sonoskin
