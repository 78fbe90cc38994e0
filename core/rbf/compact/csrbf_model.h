#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/rbf/compact/centre_index.h"
#include "core/rbf/reconstruction_options.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// FitReport: how well the function passes through the points.
//   globalError              E_global = (1/L) sqrt(Σ d_k S(p_k)² / Σ d_k) with λ = 0, L the diagonal of the points' box
//                                                                                              [thesis 3.22]
//   globalErrorWithWeights   the same with the fitted weights λ; nothing where none were fitted
struct FitReport {
  double globalError = 0;
  std::optional<double> globalErrorWithWeights;
};

// CsrbfModel: the implicit function of a surface; world mm.
//   S(x) = Σ_c (g_c(x) + λ_c) φ_c(x) / Σ_c φ_c(x)          [Ohtake et al. 2006, normalised; thesis 3.9 is not]
// S is close to the signed distance from the surface: > 0 outside (on the side of the normals), < 0 inside,
// and undefined outside all supports.
class CsrbfModel {
 public:
  CsrbfModel() = default;
  explicit CsrbfModel(std::vector<Centre> centres, const FitReport& report = {});

  // Sample: S in mm (NaN outside all supports) and the coverage Σφ, which says how well it is supported.
  struct Sample {
    float value, coverage;
  };
  Sample sample(const glm::vec3& x) const;

  // gradient: ∇S; close to a unit vector near the surface, zero outside all supports.
  glm::vec3 gradient(const glm::vec3& x) const;

  const std::vector<Centre>& centres() const { return index_.centres(); }
  const FitReport& report() const { return report_; }
  std::size_t bytes() const { return index_.bytes(); }

 private:
  CentreIndex index_;
  FitReport report_;
};

// fitCsrbf: an implicit function through oriented points.
//   points     at least 12; unit normals on one side of the surface; confidence > 0
//   solves     a quadric and a support per centre, then, if options.fitWeights, the weights λ
//   options    method adaptive, or thesis: its centres, and λ of its plain form Σ (g + λ) φ, which has the same zero set;
//              the global error is that of the plain form then. Its program built the right side b for one centre
//              only; here it is built as printed
//   cost       O(N); 113k points: 0.13 s on two cores, 0.17 s with weights; 5 million points with weights: 1.9 GB
//   errors     Error: the points span no surface (see sortPoints); Cancelled
//   threads    the result does not depend on their number
CsrbfModel fitCsrbf(const SurfacePoints& points, const ReconstructionOptions& options,
                    const Progress& progress = {});

}  // namespace sonoskin
