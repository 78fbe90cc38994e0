#include "core/rbf/compact/centres.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/base/parallel_blocks.h"
#include "core/rbf/basis.h"

namespace sonoskin {
namespace {

constexpr std::size_t kSmallestBatch = 16, kLargestBatch = 512;
constexpr std::size_t kDeferredPerBatch = 2;  // so many times a full batch are left out before it is fitted
constexpr std::size_t kFitsPerTask = 4;
constexpr int kThresholds = 10;

// The same shuffle on every machine (std::shuffle leaves the order to the library).
std::vector<std::uint32_t> randomOrder(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(7);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

struct Candidate {
  FittedCentre centre;
  SupportValues covered;
};

// Refills a candidate, whose memory is used again from batch to batch.
void fitCandidate(const SortedPoints& points, std::uint32_t point, const SupportRule& rule, float hint,
                  Candidate& candidate) {
  thread_local Neighbourhood scratch;
  candidate.centre = fitCentre(points, point, rule, double(hint), scratch);
  candidate.covered.take(candidate.centre, scratch);
}

// What is known at a point so far.
struct PointState {
  float overlap = 0, weighted = 0;  // Σ φ, Σ φ g
  float hint = 0;                   // support of the centre that last covered the point
};

class Cover {
 public:
  Cover(const SortedPoints& points, const SupportRule& rule)
      : points_(points), rule_(rule), states_(points.size()) {}

  // Goes once through the points and lifts each to `threshold`.
  void raise(const std::vector<std::uint32_t>& order, float threshold, const Progress& progress) {
    std::vector<std::uint32_t> batch, deferred, waiting;
    for (std::size_t next = 0; next < order.size() || !waiting.empty();) {
      batch.clear();
      deferred.clear();
      const auto isFull = [&] {
        return batch.size() >= batchSize_ || deferred.size() > kDeferredPerBatch * batchSize_;
      };
      const auto sort = [&](std::uint32_t point) {
        if (states_[point].overlap < threshold)
          (isCoveredBy(batch, point, threshold) ? deferred : batch).push_back(point);
      };
      std::size_t taken = 0;
      while (taken < waiting.size() && !isFull()) sort(waiting[taken++]);
      while (next < order.size() && !isFull()) sort(order[next++]);
      deferred.insert(deferred.end(), waiting.begin() + std::ptrdiff_t(taken), waiting.end());
      std::swap(waiting, deferred);
      fitAndAccept(batch, threshold, progress);
      progress.update(double(next) / double(order.size()));
    }
  }

  CentreSelection take() {
    CentreSelection result{std::move(centres_), std::vector<float>(points_.size()), {}};
    result.base.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      result.overlap[i] = states_[i].overlap;
      result.base[i] = states_[i].weighted / states_[i].overlap;
    }
    return result;
  }

 private:
  // Whether a centre at one of the points of the batch will probably lift this one to the threshold.
  bool isCoveredBy(const std::vector<std::uint32_t>& batch, std::uint32_t point, float threshold) const {
    const glm::vec3 p = points_.position(point);
    const float missing = threshold - states_[point].overlap;
    for (const std::uint32_t other : batch) {
      const float support = states_[other].hint > 0 ? states_[other].hint : lastSupport_;
      const glm::vec3 d = points_.position(other) - p;
      const float squared = glm::dot(d, d);
      if (squared < support * support && wendland(std::sqrt(squared) / support) >= missing) return true;
    }
    return false;
  }

  void fitAndAccept(const std::vector<std::uint32_t>& batch, float threshold, const Progress& progress) {
    candidates_.resize(std::max(candidates_.size(), batch.size()));
    parallelItems(batch.size(), kFitsPerTask, [&](std::size_t i) {
      progress.throwIfCancelled();
      fitCandidate(points_, batch[i], rule_, states_[batch[i]].hint, candidates_[i]);
    });
    std::size_t covered = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const Candidate& c = candidates_[i];
      covered += c.covered.points.size();
      if (states_[c.centre.point].overlap < threshold) accept(c);
    }
    // Small supports rarely overlap, so many can be fitted at once without waste. The size of a batch depends on
    // results only, never on the number of threads, and so does the outcome.
    if (covered > 0)
      batchSize_ = std::clamp(points_.size() * batch.size() / (4 * covered), kSmallestBatch, kLargestBatch);
  }

  void accept(const Candidate& c) {
    lastSupport_ = float(c.centre.sigma);
    const SupportValues& covered = c.covered;
    for (std::size_t k = 0; k < covered.points.size(); ++k) {
      PointState& state = states_[covered.points[k]];
      state.overlap += covered.phi[k];
      state.weighted += covered.weighted[k];
      state.hint = lastSupport_;
    }
    centres_.push_back(toCentre(points_, c.centre));
  }

  const SortedPoints& points_;
  SupportRule rule_;
  std::vector<PointState> states_;
  std::vector<Centre> centres_;
  std::vector<Candidate> candidates_;
  std::size_t batchSize_ = kSmallestBatch;
  float lastSupport_ = 0;
};

}  // namespace

Centre toCentre(const SortedPoints& points, const FittedCentre& fitted) {
  return {points.position(fitted.point), float(fitted.sigma), toGlobal(fitted.fit.quadric, fitted.frame), 0};
}

SupportRule supportRule(const SortedPoints& points, const ReconstructionOptions& options) {
  constexpr double kSmallestInSpacings = 1.5;
  const double smallest = kSmallestInSpacings * points.spacing;
  return {smallest, std::max(smallest, options.maxSupport * points.diagonal), points.diagonal,
          options.smoothness};
}

CentreSelection selectCentres(const SortedPoints& points, const ReconstructionOptions& options,
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
