#include "core/rbf/compact/thesis_centres.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace sonoskin {
namespace {

constexpr int kNeighbours = 19, kSteps = 10;
constexpr double kSmallest = 1e-4, kLargest = 0.07;  // of the longest axis
constexpr double kTolerance = 1e-7;                  // of L

FittedCentre fitThesisCentre(const SortedPoints& points, std::uint32_t point, const SupportRule& rule,
                             Neighbourhood& scratch) {
  scratch.gather(points, point, float(rule.largest));
  FittedCentre result;
  result.point = point;
  result.frame = frameAround({points.nx[point], points.ny[point], points.nz[point]});
  scratch.project(result.frame, float(rule.largest / 256));
  const auto fitAt = [&](double sigma) {
    return fitQuadric(scratch.within(float(sigma)), sigma, SlopeForm::printed);
  };
  const auto error = [&](double sigma) { return rule.error(fitAt(sigma).meanSquare, sigma); };
  result.sigma = thesisMinimum(error, rule.smallest, rule.largest, kTolerance * rule.diagonal);
  result.fit = fitAt(result.sigma);
  scratch.select(result.frame, float(result.sigma));
  return result;
}

// The points still below the overlap that is asked for, the least covered first.
class LeastCovered {
 public:
  LeastCovered(const std::vector<float>& overlap, float wanted) : overlap_(overlap), wanted_(wanted) {
    for (std::uint32_t i = 0; i < overlap.size(); ++i) queue_.push({overlap[i], i});
  }
  // next: the point of least overlap; false when every point has enough.
  bool next(std::uint32_t& point) {
    while (!queue_.empty()) {
      const auto [known, i] = queue_.top();
      if (overlap_[i] == known && known < wanted_) {
        point = i;
        return true;
      }
      queue_.pop();  // covered further since it was put in
      if (overlap_[i] < wanted_) queue_.push({overlap_[i], i});
    }
    return false;
  }
  std::size_t size() const { return queue_.size(); }

 private:
  using Entry = std::pair<float, std::uint32_t>;
  const std::vector<float>& overlap_;
  float wanted_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

SortedPoints thesisPoints(const SurfacePoints& points, const Progress& progress) {
  ReconstructionOptions options;
  options.neighbours = kNeighbours;
  options.confidence = false;
  SortedPoints sorted = sortPoints(points, options, progress);
  const double sum = std::accumulate(sorted.influence.begin(), sorted.influence.end(), 0.0);
  const auto mean = float(sum / double(sorted.size()));
  for (float& d : sorted.influence) d /= mean;
  return sorted;
}

double thesisMinimum(const std::function<double(double)>& error, double smallest, double largest,
                     double tolerance) {
  double low = smallest, high = largest;
  while (high - low > tolerance) {
    const double step = (high - low) / kSteps;
    double last = error(low);
    int k = 1;
    for (; k <= kSteps; ++k) {
      const double now = error(low + k * step);
      if (now > last) break;
      last = now;
    }
    if (k > kSteps) return high;  // it falls up to the end
    high = low + k * step;
    low = std::max(low, high - 2 * step);
  }
  return 0.5 * (low + high);
}

CentreSelection selectThesisCentres(const SortedPoints& points, const ReconstructionOptions& options,
                                    const Progress& progress) {
  const glm::vec3 extent = points.grid.box().max - points.grid.box().min;
  const auto unit = double(std::max({extent.x, extent.y, extent.z}));
  const SupportRule rule{kSmallest * unit, kLargest * unit, points.diagonal, options.smoothness};
  CentreSelection result{{}, std::vector<float>(points.size(), 0), std::vector<float>(points.size(), 0)};
  LeastCovered queue(result.overlap, float(options.overlap));
  Neighbourhood scratch;
  SupportValues covered;
  for (std::uint32_t point = 0; queue.next(point);) {
    progress.update(1 - double(queue.size()) / double(points.size()));
    const FittedCentre centre = fitThesisCentre(points, point, rule, scratch);
    covered.take(centre, scratch);
    for (std::size_t k = 0; k < covered.points.size(); ++k) {
      result.overlap[covered.points[k]] += covered.phi[k];
      result.base[covered.points[k]] += covered.weighted[k];
    }
    result.centres.push_back(toCentre(points, centre));
  }
  for (std::size_t i = 0; i < points.size(); ++i) result.base[i] /= result.overlap[i];
  return result;
}

}  // namespace sonoskin
