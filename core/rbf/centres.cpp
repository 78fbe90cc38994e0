#include "core/rbf/centres.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "core/base/parallel.h"
#include "core/rbf/basis.h"

namespace sonoskin {
namespace {

constexpr std::size_t kSmallestBatch = 64, kLargestBatch = 1024;
constexpr std::ptrdiff_t kFitsPerTask = 4;
constexpr int kThresholds = 10;

// The same shuffle on every machine (std::shuffle leaves the order to the library).
std::vector<std::uint32_t> randomOrder(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(7);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

// A fitted centre and the points that it covers.
struct Candidate {
  FittedCentre centre;
  std::vector<std::uint32_t> covered;
  std::vector<float> phi;
};

// Refills a candidate, whose memory is used again from batch to batch.
void fitCandidate(const SortedPoints& points, std::uint32_t point, const SupportRule& rule, float hint,
                  Candidate& candidate) {
  thread_local Neighbourhood scratch;
  candidate.centre = fitCentre(points, point, rule, double(hint), scratch);
  candidate.covered.clear();
  candidate.phi.clear();
  const auto sigma = float(candidate.centre.sigma);
  scratch.forEachWithin(sigma, [&](std::uint32_t i, float distance) {
    candidate.covered.push_back(i);
    candidate.phi.push_back(wendland(distance / sigma));
  });
}

class Cover {
 public:
  Cover(const SortedPoints& points, const SupportRule& rule)
      : points_(points), rule_(rule), overlap_(points.size(), 0), hint_(points.size(), 0) {}

  // Goes once through the points and lifts each to `threshold`.
  void raise(const std::vector<std::uint32_t>& order, float threshold, const Progress& progress) {
    std::vector<std::uint32_t> batch;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (overlap_[order[i]] < threshold) batch.push_back(order[i]);
      if (batch.size() >= batchSize_ || i + 1 == order.size()) {
        fitAndAccept(batch, threshold, progress);
        batch.clear();
        progress.update(double(i + 1) / double(order.size()));
      }
    }
  }
  std::vector<Centre> take() { return std::move(centres_); }

 private:
  void fitAndAccept(const std::vector<std::uint32_t>& batch, float threshold, const Progress& progress) {
    const auto count = std::ptrdiff_t(batch.size());
    candidates_.resize(std::max(candidates_.size(), batch.size()));
    parallelFor((count + kFitsPerTask - 1) / kFitsPerTask, [&](std::ptrdiff_t task) {
      for (std::ptrdiff_t i = task * kFitsPerTask; i < std::min(count, (task + 1) * kFitsPerTask); ++i) {
        progress.throwIfCancelled();
        const std::uint32_t point = batch[std::size_t(i)];
        fitCandidate(points_, point, rule_, hint_[point], candidates_[std::size_t(i)]);
      }
    });
    std::size_t covered = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const Candidate& c = candidates_[i];
      covered += c.covered.size();
      if (overlap_[c.centre.point] < threshold) accept(c);
    }
    // Small supports rarely overlap, so many can be fitted at once without waste. The size of a batch depends on
    // results only, never on the number of threads, and so does the outcome.
    if (covered > 0)
      batchSize_ = std::clamp(points_.size() * batch.size() / (4 * covered), kSmallestBatch, kLargestBatch);
  }

  void accept(const Candidate& c) {
    for (std::size_t k = 0; k < c.covered.size(); ++k) {
      overlap_[c.covered[k]] += c.phi[k];
      hint_[c.covered[k]] = float(c.centre.sigma);
    }
    centres_.push_back({points_.position(c.centre.point), float(c.centre.sigma),
                        toGlobal(c.centre.fit.quadric, c.centre.frame), 0});
  }

  const SortedPoints& points_;
  SupportRule rule_;
  std::vector<float> overlap_;  // o_i
  std::vector<float> hint_;     // support of the centre that last covered the point
  std::vector<Centre> centres_;
  std::vector<Candidate> candidates_;
  std::size_t batchSize_ = kSmallestBatch;
};

}  // namespace

SupportRule supportRule(const SortedPoints& points, const ReconstructionOptions& options) {
  constexpr double kSmallestInSpacings = 1.5;
  const double smallest = kSmallestInSpacings * points.spacing;
  return {smallest, std::max(smallest, options.maxSupport * points.diagonal), points.diagonal,
          options.smoothness};
}

std::vector<Centre> selectCentres(const SortedPoints& points, const ReconstructionOptions& options,
                                  const Progress& progress) {
  const std::vector<std::uint32_t> order = randomOrder(points.size());
  Cover cover(points, supportRule(points, options));
  for (int step = 1; step <= kThresholds; ++step) {
    // A centre adds φ(0) = 1 to its own point, more than a step, so one pass leaves no point below the
    // threshold.
    const auto threshold = float(options.overlap * step / kThresholds);
    cover.raise(order, threshold, progress.part(double(step - 1) / kThresholds, double(step) / kThresholds));
  }
  return cover.take();
}

}  // namespace sonoskin
