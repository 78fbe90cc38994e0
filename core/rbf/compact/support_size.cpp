#include "core/rbf/compact/support_size.h"

#include <cmath>

#include "core/rbf/basis.h"

namespace sonoskin {
namespace {

constexpr double kGrowth = 1.6;         // of the gather radius until the minimum is seen
constexpr double kHintMargin = 1.45;    // gather radius / support of the centre that covers the point
constexpr double kNormalShare = 0.6;    // of the gather radius, for the frame of the search
constexpr double kSmallestStep = 0.03;  // of ln σ
constexpr double kPointStep = 1.2;      // of σ until the support holds enough points

struct Sample {
  double sigma = 0, error = 0;
};

// The minimum of the parabola through three samples in ln σ, or nothing if it has none between them.
std::optional<double> parabolaMinimum(const Sample& a, const Sample& b, const Sample& c) {
  const double x0 = std::log(a.sigma), x1 = std::log(b.sigma), x2 = std::log(c.sigma);
  const double slope01 = (b.error - a.error) / (x1 - x0), slope12 = (c.error - b.error) / (x2 - x1);
  const double curvature = (slope12 - slope01) / (x2 - x0);
  if (!(curvature > 0)) return std::nullopt;
  const double x = 0.5 * (x0 + x1) - slope01 / (2 * curvature);
  if (!(x > x0 && x < x2) || std::abs(x - x1) < kSmallestStep) return std::nullopt;
  return std::exp(x);
}

// Narrows the bracket low, middle, high (error smallest in the middle) by two parabola steps.
template <class ErrorAt>
double refine(Sample low, Sample middle, Sample high, const ErrorAt& error) {
  for (int step = 0; step < 2; ++step) {
    const std::optional<double> sigma = parabolaMinimum(low, middle, high);
    if (!sigma) break;
    const std::optional<double> value = error(*sigma);
    if (!value) break;
    const Sample tried{*sigma, *value};
    const bool above = tried.sigma > middle.sigma;
    if (tried.error < middle.error) {
      (above ? low : high) = middle;
      middle = tried;
    } else {
      (above ? high : low) = tried;
    }
  }
  return middle.sigma;
}

}  // namespace

std::optional<double> firstMinimum(const std::function<std::optional<double>(double)>& error, double smallest,
                                   double reach, double largest) {
  std::optional<Sample> before, last;
  bool isEnd = false;
  for (int k = 0; !isEnd; ++k) {
    double sigma = smallest * std::exp2(0.5 * k);
    if (sigma > 0.97 * reach) {  // a level that all but coincides with the end is replaced by it
      if (reach < largest && sigma > reach) return std::nullopt;
      sigma = reach;
      isEnd = true;
    }
    const std::optional<double> value = error(sigma);
    if (!value) continue;
    const Sample now{sigma, *value};
    if (last && now.error >= last->error) return before ? refine(*before, *last, now, error) : last->sigma;
    before = last;
    last = now;
  }
  return last && reach >= largest ? std::optional(last->sigma) : std::nullopt;
}

namespace {

// Projects the gathered points for the search of a support of up to `radius`.
std::optional<double> searchSupport(Neighbourhood& scratch, double radius, const SupportRule& rule) {
  scratch.project(frameAround(scratch.meanNormal(float(kNormalShare * radius))), float(rule.smallest));
  const auto error = [&](double sigma) -> std::optional<double> {
    // At least half of a flat neighbourhood's samples are closer than sigma, so only few need to be counted.
    const LocalSamples samples = scratch.within(float(sigma));
    const bool areMany = samples.count > 8 * kMinPointsInSupport;
    if (!areMany && scratch.countWithin(float(sigma)) < kMinPointsInSupport) return std::nullopt;
    return rule.error(fitQuadric(samples, sigma).meanSquare, sigma);
  };
  return firstMinimum(error, rule.smallest, radius, rule.largest);
}

}  // namespace

FittedCentre fitCentre(const SortedPoints& points, std::size_t centre, const SupportRule& given, double hint,
                       Neighbourhood& scratch) {
  const SupportRule rule = points.noise.empty() ? given : given.atNoise(double(points.noise[centre]));
  double radius = hint > 0 ? std::max(kHintMargin * hint, 2 * rule.smallest) : 4 * rule.smallest;
  radius = std::min(radius, rule.largest);
  std::optional<double> sigma;
  for (;;) {
    scratch.gather(points, centre, float(radius));
    if (scratch.size() >= kMinPointsInSupport) sigma = searchSupport(scratch, radius, rule);
    if (sigma) break;
    // Beyond the largest support only where the points are so sparse that it holds too few of them.
    radius = radius < rule.largest ? std::min(kGrowth * radius, rule.largest) : kPointStep * radius;
  }
  while (scratch.countWithin(float(*sigma)) < kMinPointsInSupport)
    *sigma = std::min(kPointStep * *sigma, radius);

  FittedCentre result{std::uint32_t(centre), *sigma, frameAround(scratch.meanNormal(float(*sigma))), {}};
  scratch.select(result.frame, float(*sigma));
  result.fit = fitQuadric(scratch.selection(), *sigma);
  return result;
}

void SupportValues::take(const FittedCentre& centre, const Neighbourhood& selected) {
  points.assign(selected.selected().begin(), selected.selected().end());
  const LocalSamples s = selected.selection();
  phi.resize(s.count);
  weighted.resize(s.count);
  float *outPhi = phi.data(), *outWeighted = weighted.data();
  const auto inverse = float(1 / centre.sigma);
  const LocalQuadric& q = centre.fit.quadric;
  const auto A = float(q.A), B2 = float(2 * q.B), C = float(q.C), D = float(q.D), E = float(q.E),
             F = float(q.F);
#pragma omp simd
  for (std::size_t j = 0; j < s.count; ++j) {
    const float u = s.u[j], v = s.v[j];
    outPhi[j] = wendland(s.r[j] * inverse);
    outWeighted[j] = outPhi[j] * (s.w[j] - (u * (A * u + B2 * v + D) + v * (C * v + E) + F));
  }
}

}  // namespace sonoskin
