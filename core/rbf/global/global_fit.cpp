#include "core/rbf/global/global_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/rbf/global/global_solver.h"

namespace sonoskin {
namespace {

constexpr std::size_t kFirstCentres = 1024;
constexpr std::size_t kNeighbourhood = 32;  // points of which at most one is added in a round

void checkOptions(const GlobalOptions& options) {
  const int least = minimumDegree(options.basis);
  if (options.degree >= least) return;
  const auto names = enumNames(options.basis);
  throw Error(fmt::format("global.degree is {}, but the basis {} needs at least {}.", options.degree,
                          names[std::size_t(options.basis)], least),
              Error::Kind::usage);
}

// GreedyFit: what the rounds share; everything in the unit frame but the values, mm.
struct GreedyFit {
  const GlobalPoints& points;
  const GlobalOptions& options;
  UnitFrame frame;
  Sites sites;
  RadialKernel kernel;
  double nugget = 0;
  SiteLeaves leaves;                   // neighbourhoods
  std::vector<std::uint32_t> centres;  // indices of sites
  Eigen::VectorXd weights;             // of the centres of the last round
  GlobalRbf model;
};

GreedyFit prepare(const GlobalPoints& points, const GlobalOptions& options) {
  GreedyFit fit{points, options, unitFrame(points.sites), {}, {}, 0, {}, {}, {}, {}};
  fit.sites = toUnit(fit.frame, points.sites);
  fit.kernel = {options.basis, options.width / fit.frame.scale};
  fit.nugget = options.nugget * kernelVariation(fit.kernel, options.offset / fit.frame.scale);
  fit.leaves = splitIntoLeaves(fit.sites, kNeighbourhood);
  require(
      PolynomialSpace(fit.sites, options.degree).isComplete(),
      "The points do not determine a polynomial of degree {}: they lie on a surface of that degree; lower "
      "global.degree.",
      options.degree);
  const std::size_t n = fit.sites.size(), first = options.accuracy > 0 ? std::min(n, kFirstCentres) : n;
  for (std::size_t k = 0; k < first; ++k) fit.centres.push_back(fit.leaves.order[k * n / first]);
  return fit;
}

void solveRound(GreedyFit& fit, const Progress& progress) {
  require(
      fit.centres.size() <= std::size_t(fit.options.maxCentres),
      "The surface needs more than {} centres: raise global.accuracy, lower global.offsetShare, or choose "
      "reconstruction.method adaptive.",
      fit.options.maxCentres);
  Eigen::VectorXd values(Eigen::Index(fit.centres.size()));
  for (std::size_t k = 0; k < fit.centres.size(); ++k)
    values[Eigen::Index(k)] = fit.points.values[fit.centres[k]];
  Eigen::VectorXd start = Eigen::VectorXd::Zero(fit.weights.size() > 0 ? values.size() : 0);
  if (start.size() > 0) start.head(fit.weights.size()) = fit.weights;
  const GlobalSystem system{pick(fit.sites, fit.centres), fit.kernel, fit.options.degree, fit.nugget};
  SolverOptions solver;
  solver.tolerance = fit.options.tolerance;
  const GlobalSolution found = solveGlobal(system, values, start, solver, progress);
  // The residual by the recursion and the true one differ by rounding.
  require(
      found.relativeResidual <= 2 * solver.tolerance,
      "The global fit did not converge (residual {:.1e} after {} steps): choose a smaller global.width, a "
      "larger global.nugget, a larger global.tolerance or another global.basis.",
      found.relativeResidual, found.steps);
  fit.weights = found.weights;
  GlobalFitReport report = fit.model.report();
  report.constraints = fit.points.size();
  ++report.rounds;
  report.steps = found.steps;
  report.relativeResidual = found.relativeResidual;
  const auto toVector = [](const Eigen::VectorXd& v) { return std::vector<double>(v.begin(), v.end()); };
  fit.model = GlobalRbf(
      {fit.frame, fit.kernel, system.sites, toVector(found.weights), toVector(found.polynomial)}, report);
}

// How far a point may be missed, mm.
double tolerated(const GreedyFit& fit, std::size_t point) {
  return std::max(fit.options.accuracy, 0.5 * std::abs(fit.points.values[point]));
}

// Residuals at all points; notes in the model's report how large they are.
std::vector<double> measureResiduals(GreedyFit& fit, const Progress& progress) {
  std::vector<double> residuals = fit.model.values(fit.points.sites, progress);
  GlobalFitReport report = fit.model.report();
  report.largestResidual = report.largestOffSurface = 0;
  double squares = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    residuals[i] = std::abs(fit.points.values[i] - residuals[i]);
    const bool isOnSurface = i < fit.points.onSurface;
    double& largest = isOnSurface ? report.largestResidual : report.largestOffSurface;
    largest = std::max(largest, residuals[i]);
    if (isOnSurface) squares += residuals[i] * residuals[i];
  }
  if (fit.points.onSurface > 0) report.rmsResidual = std::sqrt(squares / double(fit.points.onSurface));
  fit.model = GlobalRbf(fit.model.parts(), report);
  return residuals;
}

// Adds the worst point of every neighbourhood that has one beyond what is tolerated; returns whether there was one.
bool addWorst(GreedyFit& fit, const std::vector<double>& residuals) {
  std::vector<bool> isCentre(fit.sites.size());
  for (const std::uint32_t c : fit.centres) isCentre[c] = true;
  const std::size_t before = fit.centres.size();
  for (std::size_t leaf = 0; leaf < fit.leaves.count(); ++leaf) {
    double worst = 1;
    std::uint32_t found = 0;
    for (std::size_t k = fit.leaves.begin[leaf]; k < fit.leaves.begin[leaf + 1]; ++k) {
      const std::uint32_t i = fit.leaves.order[k];
      const double share = isCentre[i] ? 0 : residuals[i] / tolerated(fit, i);
      if (share > worst) worst = share, found = i;
    }
    if (worst > 1) fit.centres.push_back(found);
  }
  return fit.centres.size() > before;
}

}  // namespace

GlobalRbf fitGlobal(const GlobalPoints& points, const GlobalOptions& options, const Progress& progress) {
  checkOptions(options);
  GreedyFit fit = prepare(points, options);
  double done = 0;
  for (bool isGrowing = true; isGrowing;) {
    const double next = done + 0.3 * (1 - done);  // nobody knows how many rounds there will be
    const Progress round = progress.part(done, next);
    solveRound(fit, round.part(0, 0.7));
    isGrowing = addWorst(fit, measureResiduals(fit, round.part(0.7, 1)));
    done = next;
  }
  progress.update(1);
  return fit.model;
}

GlobalRbf fitGlobal(const SurfacePoints& points, const GlobalOptions& options, const Progress& progress) {
  checkOptions(options);
  return fitGlobal(makeGlobalPoints(points, options, progress.part(0, 0.05)), options,
                   progress.part(0.05, 1));
}

}  // namespace sonoskin
