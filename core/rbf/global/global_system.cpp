#include "core/rbf/global/global_system.h"

#include <algorithm>

#include "core/base/parallel_blocks.h"
#include "core/rbf/global/global_kernels.h"

namespace sonoskin {
namespace {

constexpr std::size_t kStripes = 32;  // fixed, so that sums are added in the same order on any machine
constexpr std::size_t kTargetsPerTask = 64;

Eigen::Map<const Eigen::ArrayXd> arrayOf(const std::vector<double>& v) {
  return {v.data(), Eigen::Index(v.size())};
}

// Squared distances from p to the `count` sites from `first` on.
void squaredDistances(const Sites& sites, std::size_t first, std::size_t count, const glm::dvec3& p,
                      KernelChunk& chunk) {
  const auto from = Eigen::Index(first), n = Eigen::Index(count);
  chunk = (arrayOf(sites.x).segment(from, n) - p.x).square() +
          (arrayOf(sites.y).segment(from, n) - p.y).square() +
          (arrayOf(sites.z).segment(from, n) - p.z).square();
}

// A tile of A: rows [row, rowEnd) and the columns of one chunk, all of them later than the rows.
struct MatrixTile {
  std::size_t row, rowEnd, column;
};

// Both halves of a tile of A w.
template <class Kernel>
void addTile(const Kernel& kernel, const Sites& sites, const VectorRef& w, const MatrixTile& tile,
             Eigen::VectorXd& out) {
  const auto [row, rowEnd, column] = tile;
  const std::size_t count = std::min(kKernelChunk, sites.size() - column);
  const auto at = Eigen::Index(column), n = Eigen::Index(count);
  const KernelChunk weights = w.segment(at, n).array();
  KernelChunk chunk(n), sums = KernelChunk::Zero(n);
  for (std::size_t i = row; i < rowEnd; ++i) {
    squaredDistances(sites, column, count, sites[i], chunk);
    kernel.value(chunk);
    out[Eigen::Index(i)] += (weights * chunk).sum();
    sums += w[Eigen::Index(i)] * chunk;
  }
  out.segment(at, n).array() += sums;
}

// The tile on the diagonal, where a row meets itself.
template <class Kernel>
void addDiagonalTile(const Kernel& kernel, const Sites& sites, const VectorRef& w, std::size_t row,
                     std::size_t rowEnd, Eigen::VectorXd& out) {
  const auto at = Eigen::Index(row), n = Eigen::Index(rowEnd - row);
  KernelChunk chunk(n);
  for (std::size_t i = row; i < rowEnd; ++i) {
    squaredDistances(sites, row, rowEnd - row, sites[i], chunk);
    kernel.value(chunk);
    out[Eigen::Index(i)] += (w.segment(at, n).array() * chunk).sum();
  }
}

template <class Kernel>
double sumAt(const Kernel& kernel, const Sites& sites, const VectorRef& w, const glm::dvec3& p) {
  double sum = 0;
  KernelChunk chunk;
  for (std::size_t first = 0; first < sites.size(); first += kKernelChunk) {
    const std::size_t count = std::min(kKernelChunk, sites.size() - first);
    squaredDistances(sites, first, count, p, chunk);
    kernel.value(chunk);
    sum += (w.segment(Eigen::Index(first), Eigen::Index(count)).array() * chunk).sum();
  }
  return sum;
}

template <class Kernel>
glm::dvec3 gradientAt(const Kernel& kernel, const Sites& sites, const VectorRef& w, const glm::dvec3& p) {
  glm::dvec3 sum(0);
  KernelChunk chunk;
  for (std::size_t first = 0; first < sites.size(); first += kKernelChunk) {
    const std::size_t count = std::min(kKernelChunk, sites.size() - first);
    const auto at = Eigen::Index(first), n = Eigen::Index(count);
    squaredDistances(sites, first, count, p, chunk);
    kernel.slope(chunk);
    chunk *= w.segment(at, n).array();
    sum.x += (chunk * (p.x - arrayOf(sites.x).segment(at, n))).sum();
    sum.y += (chunk * (p.y - arrayOf(sites.y).segment(at, n))).sum();
    sum.z += (chunk * (p.z - arrayOf(sites.z).segment(at, n))).sum();
  }
  return sum;
}

// Calls f(kernel, target) for every target, on all threads.
template <class F>
void forEachTarget(const RadialKernel& kernel, std::size_t count, const Progress& progress, const F& f) {
  const auto body = [&](std::size_t first, std::size_t end) {
    withKernel(kernel, [&](const auto& k) {
      for (std::size_t t = first; t < end; ++t) f(k, t);
    });
  };
  parallelBlocks(count, kTargetsPerTask, body, progress);
}

}  // namespace

Eigen::VectorXd kernelProduct(const RadialKernel& kernel, const Sites& sites, const VectorRef& weights,
                              const Progress& progress) {
  const std::size_t n = sites.size(), stripe = kStripes * kKernelChunk;
  std::vector<Eigen::VectorXd> parts(kStripes);
  const auto body = [&](std::ptrdiff_t task) {
    Eigen::VectorXd& out = parts[std::size_t(task)];
    out = Eigen::VectorXd::Zero(Eigen::Index(n));
    withKernel(kernel, [&](const auto& k) {
      for (std::size_t row = std::size_t(task) * kKernelChunk; row < n; row += stripe) {
        progress.throwIfCancelled();
        const std::size_t rowEnd = std::min(row + kKernelChunk, n);
        addDiagonalTile(k, sites, weights, row, rowEnd, out);
        for (std::size_t column = rowEnd; column < n; column += kKernelChunk)
          addTile(k, sites, weights, {row, rowEnd, column}, out);
      }
    });
  };
  parallelFor(std::ptrdiff_t(kStripes), body, progress);
  Eigen::VectorXd result = parts[0];
  for (std::size_t t = 1; t < kStripes; ++t) result += parts[t];
  return result;
}

Eigen::VectorXd kernelSums(const RadialKernel& kernel, const Sites& sites, const VectorRef& weights,
                           const Sites& targets, const Progress& progress) {
  Eigen::VectorXd result(Eigen::Index(targets.size()));
  forEachTarget(kernel, targets.size(), progress, [&](const auto& k, std::size_t t) {
    result[Eigen::Index(t)] = sumAt(k, sites, weights, targets[t]);
  });
  return result;
}

std::vector<glm::dvec3> kernelGradients(const RadialKernel& kernel, const Sites& sites,
                                        const VectorRef& weights, const Sites& targets,
                                        const Progress& progress) {
  std::vector<glm::dvec3> result(targets.size());
  forEachTarget(kernel, targets.size(), progress,
                [&](const auto& k, std::size_t t) { result[t] = gradientAt(k, sites, weights, targets[t]); });
  return result;
}

Eigen::MatrixXd kernelMatrix(const RadialKernel& kernel, const Sites& sites) {
  const std::size_t n = sites.size();
  Eigen::MatrixXd matrix(n, n);
  KernelChunk chunk;
  withKernel(kernel, [&](const auto& k) {
    for (std::size_t column = 0; column < n; ++column)
      for (std::size_t first = 0; first < n; first += kKernelChunk) {
        const std::size_t count = std::min(kKernelChunk, n - first);
        squaredDistances(sites, first, count, sites[column], chunk);
        k.value(chunk);
        matrix.col(Eigen::Index(column)).segment(Eigen::Index(first), Eigen::Index(count)) = chunk.matrix();
      }
  });
  return matrix;
}

}  // namespace sonoskin
