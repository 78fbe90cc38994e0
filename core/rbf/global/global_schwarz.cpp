#include "core/rbf/global/global_schwarz.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr double kRankThreshold = 1e-12;  // a leaf of a smooth surface is nearly flat
constexpr double kFirstShift = 1e-14, kShiftFactor = 100;

GlobalSystem subsystem(const GlobalSystem& system, const std::vector<std::uint32_t>& sites) {
  return {pick(system.sites, sites), system.kernel, system.degree, system.nugget};
}

Eigen::VectorXd gather(const Eigen::VectorXd& v, const std::vector<std::uint32_t>& indices) {
  Eigen::VectorXd result(Eigen::Index(indices.size()));
  for (std::size_t k = 0; k < indices.size(); ++k) result[Eigen::Index(k)] = v[indices[k]];
  return result;
}

// Monomials around the sites' own middle and size, so that their rank can be told for small domains too.
Eigen::MatrixXd localMonomials(const GlobalSystem& system) {
  return monomialMatrix(toUnit(unitFrame(system.sites), system.sites), system.degree);
}

double outsideSquared(const glm::dvec3& p, const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 gap = glm::max(glm::max(low - p, p - high), glm::dvec3(0));
  return glm::dot(gap, gap);
}

}  // namespace

DenseFactors::DenseFactors(const GlobalSystem& system) {
  Eigen::MatrixXd matrix = kernelMatrix(system.kernel, system.sites);
  matrix.diagonal().array() += system.nugget;
  if (system.degree >= 0) {
    qr_.setThreshold(kRankThreshold);
    qr_.compute(localMonomials(system));
    rank_ = qr_.rank();
    const auto q = qr_.householderQ().setLength(rank_);
    matrix.applyOnTheLeft(q.adjoint());
    matrix.applyOnTheRight(q);
  }
  const Eigen::Index n = matrix.rows() - rank_;
  const Eigen::MatrixXd inner = matrix.bottomRightCorner(n, n);
  const double largest = n > 0 ? inner.diagonal().maxCoeff() : 0;
  cholesky_.compute(inner);
  for (double shift = kFirstShift; cholesky_.info() != Eigen::Success && shift < 1; shift *= kShiftFactor)
    cholesky_.compute(inner + shift * largest * Eigen::MatrixXd::Identity(n, n));
}

Eigen::VectorXd DenseFactors::solve(const Eigen::VectorXd& f) const {
  if (rank_ == 0) return cholesky_.solve(f);
  const auto q = qr_.householderQ().setLength(rank_);
  Eigen::VectorXd turned = q.adjoint() * f;
  const Eigen::Index n = turned.size() - rank_;
  turned.head(rank_).setZero();
  turned.tail(n) = cholesky_.solve(turned.tail(n)).eval();
  return q * turned;
}

SchwarzPreconditioner::SchwarzPreconditioner(const GlobalSystem& system, const PolynomialSpace& polynomials,
                                             const SchwarzOptions& options, const Progress& progress)
    : system_(system), polynomials_(polynomials) {
  const bool isWhole = system.sites.size() <= 2 * options.leaf;
  const SiteLeaves leaves = splitIntoLeaves(system.sites, isWhole ? 2 * options.leaf : options.leaf);
  domains_.resize(leaves.count());
  if (!isWhole && options.coarse > 0) chooseCoarse(leaves, options.coarse);
  // The coarse system is the largest piece of work: it comes first.
  parallelFor(
      std::ptrdiff_t(domains_.size()) + 1,
      [&](std::ptrdiff_t task) {
        Domain& domain = task == 0 ? coarse_ : domains_[std::size_t(task) - 1];
        if (task > 0) addOverlap(leaves, std::size_t(task) - 1, domain);
        if (!domain.sites.empty()) domain.factors.emplace_back(subsystem(system_, domain.sites));
      },
      progress);
}

void SchwarzPreconditioner::addOverlap(const SiteLeaves& leaves, std::size_t leaf, Domain& domain) const {
  const std::size_t first = leaves.begin[leaf], last = leaves.begin[leaf + 1];
  glm::dvec3 low = system_.sites[leaves.order[first]], high = low;
  for (std::size_t i = first; i < last; ++i) {
    low = glm::min(low, system_.sites[leaves.order[i]]);
    high = glm::max(high, system_.sites[leaves.order[i]]);
  }
  std::vector<std::pair<double, std::uint32_t>> others;
  for (std::size_t i = 0; i < leaves.order.size(); ++i)
    if (i < first || i >= last)
      others.emplace_back(outsideSquared(system_.sites[leaves.order[i]], low, high), leaves.order[i]);
  domain.inner = last - first;
  const auto count = std::ptrdiff_t(std::min(domain.inner, others.size()));
  std::nth_element(others.begin(), others.begin() + count, others.end());
  domain.sites.assign(leaves.order.begin() + std::ptrdiff_t(first),
                      leaves.order.begin() + std::ptrdiff_t(last));
  for (auto i = others.begin(); i != others.begin() + count; ++i) domain.sites.push_back(i->second);
}

void SchwarzPreconditioner::chooseCoarse(const SiteLeaves& leaves, std::size_t count) {
  const std::size_t n = leaves.order.size(), most = std::min(count, n);
  for (std::size_t k = 0; k < most; ++k) coarse_.sites.push_back(leaves.order[k * n / most]);
  coarse_.inner = most;
}

void SchwarzPreconditioner::addCoarse(const Eigen::VectorXd& residual, Eigen::VectorXd& weights,
                                      const Progress& progress) const {
  const Sites sites = pick(system_.sites, coarse_.sites);
  const Eigen::VectorXd left = gather(residual, coarse_.sites) -
                               kernelSums(system_.kernel, system_.sites, weights, sites, progress) -
                               system_.nugget * gather(weights, coarse_.sites);
  const Eigen::VectorXd correction = coarse_.factors[0].solve(left);
  for (std::size_t k = 0; k < coarse_.sites.size(); ++k)
    weights[coarse_.sites[k]] += correction[Eigen::Index(k)];
}

Eigen::VectorXd SchwarzPreconditioner::apply(const Eigen::VectorXd& residual,
                                             const Progress& progress) const {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(residual.size());
  parallelFor(
      std::ptrdiff_t(domains_.size()),
      [&](std::ptrdiff_t d) {
        const Domain& domain = domains_[std::size_t(d)];
        const Eigen::VectorXd local = domain.factors[0].solve(gather(residual, domain.sites));
        for (std::size_t k = 0; k < domain.inner; ++k) weights[domain.sites[k]] = local[Eigen::Index(k)];
      },
      progress);
  polynomials_.project(weights);
  if (!coarse_.sites.empty()) {
    addCoarse(residual, weights, progress);
    polynomials_.project(weights);
  }
  return weights;
}

}  // namespace sonoskin
