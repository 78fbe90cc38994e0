#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/rbf/global/global_basis.h"
#include "core/rbf/global/global_sites.h"

namespace sonoskin {

// GlobalFitReport: how well a global function fits.
struct GlobalFitReport {
  std::size_t constraints = 0;   // points on and off the surface that it was held against
  int rounds = 0;                // of adding centres
  int steps = 0;                 // of the solver in the last round
  double relativeResidual = 0;   // of the solver
  double rmsResidual = 0;        // mm, over the points on the surface
  double largestResidual = 0;    // mm, likewise
  double largestOffSurface = 0;  // mm, over those beside it
};

// GlobalRbf: one radial basis function over all centres, world mm.
//   S(x) = Σ_i λ_i φ(|x - x_i|) + P(x)                                       [Carr et al. 2001; thesis 2.3.2]
// S is 0 on the surface, > 0 outside and defined everywhere; near the surface it is close to the signed distance.
class GlobalRbf {
 public:
  // Parts: in the unit frame; `polynomial` holds the coefficients of the monomials.
  struct Parts {
    UnitFrame frame;
    RadialKernel kernel;
    Sites centres;
    std::vector<double> weights, polynomial;
  };
  GlobalRbf() = default;
  GlobalRbf(Parts parts, const GlobalFitReport& report) : parts_(std::move(parts)), report_(report) {}

  // value, gradient: by the direct sum.
  double value(const glm::dvec3& x) const;
  glm::dvec3 gradient(const glm::dvec3& x) const;

  // values: of many places, on all threads; mm.
  //   cost     places times centres; 1 G per second and core for the harmonic kernels
  //   errors   Cancelled
  std::vector<double> values(const Sites& places, const Progress& progress = {}) const;

  const Parts& parts() const { return parts_; }
  const GlobalFitReport& report() const { return report_; }
  std::size_t size() const { return parts_.centres.size(); }
  std::size_t bytes() const { return size() * 4 * sizeof(double); }

 private:
  Parts parts_;
  GlobalFitReport report_;
};

}  // namespace sonoskin
