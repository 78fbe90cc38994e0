#include "core/rbf/compact/csrbf_model.h"

#include <algorithm>
#include <limits>

#include "core/rbf/basis.h"
#include "core/rbf/compact/centres.h"
#include "core/rbf/compact/lambda_fit.h"
#include "core/rbf/compact/thesis_centres.h"

namespace sonoskin {
namespace {

constexpr float kCellsAlongBox = 32;

float indexCell(const std::vector<Centre>& centres) {
  if (centres.empty()) return 1;
  std::vector<glm::vec3> corners;
  for (const Centre& c : centres) {
    corners.push_back(c.position - c.support);
    corners.push_back(c.position + c.support);
  }
  const Box box = boundingBox(corners);
  const glm::vec3 extent = box.max - box.min;
  return std::max({extent.x, extent.y, extent.z}) / kCellsAlongBox;
}

}  // namespace

CsrbfModel::CsrbfModel(std::vector<Centre> centres, const FitReport& report) : report_(report) {
  const float cell = indexCell(centres);
  index_ = CentreIndex(std::move(centres), cell, 0);
}

CsrbfModel::Sample CsrbfModel::sample(const glm::vec3& x) const {
  float weighted = 0, coverage = 0;
  for (const std::uint32_t n : index_.near(x)) {
    const Centre& c = centres()[n];
    const glm::vec3 d = x - c.position;
    const float phi = wendland(glm::length(d) / c.support);
    weighted += phi * (c.quadric.value(d.x, d.y, d.z) + c.lambda);
    coverage += phi;
  }
  return {coverage > 0 ? weighted / coverage : std::numeric_limits<float>::quiet_NaN(), coverage};
}

// ∇S = Σ_c [φ_c ∇g_c + (g_c + λ_c - S) ∇φ_c] / Σ_c φ_c
glm::vec3 CsrbfModel::gradient(const glm::vec3& x) const {
  const Sample s = sample(x);
  if (!(s.coverage > 0)) return glm::vec3(0);
  glm::vec3 sum(0);
  for (const std::uint32_t n : index_.near(x)) {
    const Centre& c = centres()[n];
    const glm::vec3 d = x - c.position;
    const float t = glm::length(d) / c.support;
    const float g = c.quadric.value(d.x, d.y, d.z) + c.lambda;
    const glm::vec3 phiGradient = wendlandGradientFactor(t) / (c.support * c.support) * d;
    sum += wendland(t) * c.quadric.gradient(d.x, d.y, d.z) + (g - s.value) * phiGradient;
  }
  return sum / s.coverage;
}

CsrbfModel fitCsrbf(const SurfacePoints& points, const ReconstructionOptions& options,
                    const Progress& progress) {
  const bool isThesis = options.method == ReconstructionMethod::thesis;
  const FunctionForm form = isThesis ? FunctionForm::plain : FunctionForm::normalised;
  const double pointsTo = isThesis ? 0.1 : 0.3, centresTo = options.fitWeights ? (isThesis ? 0.9 : 0.6) : 1;
  const Progress first = progress.part(0, pointsTo), second = progress.part(pointsTo, centresTo);
  const SortedPoints sorted = isThesis ? thesisPoints(points, first) : sortPoints(points, options, first);
  CentreSelection selection =
      isThesis ? selectThesisCentres(sorted, options, second) : selectCentres(sorted, options, second);
  FitReport report;
  report.globalError = globalError(sorted, valuesAtPoints(selection, form));
  if (options.fitWeights)
    report.globalErrorWithWeights = globalError(
        sorted, fitLambda(sorted, options.regularisation, selection, form, progress.part(centresTo, 1)));
  return CsrbfModel(std::move(selection.centres), report);
}

}  // namespace sonoskin
