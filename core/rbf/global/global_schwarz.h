#pragma once

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <vector>

#include "core/base/progress.h"
#include "core/rbf/global/global_polynomial.h"
#include "core/rbf/global/global_system.h"

namespace sonoskin {

// GlobalSystem: [A + ρI  Q; Qᵀ 0] [λ; p] = [f; 0] on some sites.
struct GlobalSystem {
  Sites sites;  // in the unit box
  RadialKernel kernel;
  int degree = 1;
  double nugget = 0;
};

// DenseFactors: the exact solution of a small global system.
//   method   Householder reflections turn A into the space where Qᵀλ = 0; there it is positive definite and is
//            solved by Cholesky's factors. Sites on which the polynomials are not independent do no harm. Where
//            rounding has made the matrix indefinite, a small shift of its diagonal mends it.
//   cost     n³/3; 512 sites: 10 ms, 2 MB
class DenseFactors {
 public:
  explicit DenseFactors(const GlobalSystem& system);
  Eigen::VectorXd solve(const Eigen::VectorXd& f) const;  // λ

 private:
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr_;
  Eigen::Index rank_ = 0;
  Eigen::LLT<Eigen::MatrixXd> cholesky_;
};

// SchwarzOptions: sizes of the decomposition.
struct SchwarzOptions {
  std::size_t leaf = 256;     // inner sites of a domain, at most; the overlap takes as many again
  std::size_t coarse = 1024;  // sites of the coarse level; 0: none
};

// SchwarzPreconditioner: an approximate inverse of a global system.
//   method   restricted additive Schwarz: the system on each domain, a leaf with an overlap of the sites nearest to
//            it, is solved exactly, and the inner weights are kept; then the system on some sites spread over all
//            leaves is solved for what is left there                                     [Beatson et al. 2000]
//   cost     setup 12 ms per domain; 8 KB per site; apply: two triangular solves per domain, coarse N kernels
//   errors   Cancelled
class SchwarzPreconditioner {
 public:
  SchwarzPreconditioner(const GlobalSystem& system, const PolynomialSpace& polynomials,
                        const SchwarzOptions& options, const Progress& progress = {});
  Eigen::VectorXd apply(const Eigen::VectorXd& residual, const Progress& progress = {}) const;

 private:
  struct Domain {
    std::vector<std::uint32_t> sites;  // the inner ones first
    std::size_t inner = 0;
    std::vector<DenseFactors> factors;  // one, after its setup
  };

  void addOverlap(const SiteLeaves& leaves, std::size_t leaf, Domain& domain) const;
  void chooseCoarse(const SiteLeaves& leaves, std::size_t count);
  void addCoarse(const Eigen::VectorXd& residual, Eigen::VectorXd& weights, const Progress& progress) const;

  const GlobalSystem& system_;
  const PolynomialSpace& polynomials_;
  std::vector<Domain> domains_;
  Domain coarse_;
};

}  // namespace sonoskin
