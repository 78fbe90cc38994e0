#include "core/skin/fit_gaussians.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/skin/nelder_mead.h"
#include "core/skin/nnls.h"

namespace sonoskin {
namespace {

constexpr double kPi = std::numbers::pi;

// exp(x^2) erfc(x) for x >= 0.
double scaledErfc(double x) {
  if (x < 5) return std::exp(x * x) * std::erfc(x);
  double fraction = 0;  // the continued fraction of Laplace, from its tail
  for (int k = 24; k >= 1; --k) fraction = 0.5 * k / (x + fraction);
  return 1 / (std::sqrt(kPi) * (x + fraction));
}

// int_decay^inf q exp(-z q - v (q^2 - decay^2) / 2) dq: a source at z in the Hankel domain against a
// Gaussian.
double sourceOnGaussian(double z, double decay, double v) {
  const double t = (v * decay + z) / std::sqrt(2 * v);
  return std::exp(-z * decay) / v * (1 - z * std::sqrt(kPi / (2 * v)) * scaledErfc(t));
}

// int_decay^inf q exp(-c q) dq.
double sourceOnSource(double c, double decay) { return std::exp(-c * decay) * (decay / c + 1 / (c * c)); }

// The products of the plane below are int f g 2 pi r dr, by Parseval int F G s ds / 2 pi.
double onGaussian(const Dipole& d, double v) {
  return d.albedo / (4 * kPi) *
         (sourceOnGaussian(d.real, d.decay, v) + sourceOnGaussian(d.virtualSource, d.decay, v));
}

double onItself(const Dipole& d) {
  return d.albedo * d.albedo / (8 * kPi) *
         (sourceOnSource(2 * d.real, d.decay) + 2 * sourceOnSource(d.real + d.virtualSource, d.decay) +
          sourceOnSource(2 * d.virtualSource, d.decay));
}

struct ChannelFit {
  std::vector<double> weights;
  double squaredError = 0;  // relative
};

ChannelFit fitChannel(const Dipole& dipole, std::span<const double> variances) {
  const size_t n = variances.size();
  const double total = totalReflectance(dipole), norm = onItself(dipole);
  std::vector<double> gram(n * n), rhs(n);
  for (size_t i = 0; i < n; ++i) {
    rhs[i] = total * onGaussian(dipole, variances[i]) / norm;
    for (size_t j = 0; j < n; ++j)
      gram[i * n + j] = total * total / (2 * kPi * (variances[i] + variances[j])) / norm;
  }
  ChannelFit fit{nonNegativeShares(gram, rhs), 1};
  for (size_t i = 0; i < n; ++i) {
    double applied = 0;
    for (size_t j = 0; j < n; ++j) applied += gram[i * n + j] * fit.weights[j];
    fit.squaredError += fit.weights[i] * (applied - 2 * rhs[i]);
  }
  fit.squaredError = std::max(fit.squaredError, 0.0);
  return fit;
}

std::vector<double> exponentials(std::vector<double> logarithms) {
  for (double& value : logarithms) value = std::exp(value);
  std::sort(logarithms.begin(), logarithms.end());
  return logarithms;
}

// Start number `attempt` of six: even steps of the logarithm between variances that the dipoles suggest.
std::vector<double> firstLogarithms(const DipoleRgb& dipoles, int count, int attempt) {
  double least = 1e300, most = 0;
  for (const Dipole& d : dipoles) {
    least = std::min(least, d.real * d.real);
    most = std::max(most, 1 / (d.decay * d.decay));
  }
  constexpr std::array<double, 6> kLow{0.15, 0.3, 0.08, 0.2, 0.5, 0.1};
  constexpr std::array<double, 6> kHigh{2.0, 1.0, 3.0, 0.5, 1.5, 1.2};
  const double low = std::log(kLow[size_t(attempt)] * least), high = std::log(kHigh[size_t(attempt)] * most);
  std::vector<double> start;
  for (int i = 0; i < count; ++i) start.push_back(low + (high - low) * (i + 0.5) / count);
  return start;
}

}  // namespace

DipoleRgb makeDipoles(const MediumRgb& medium) {
  return {makeDipole(medium[0]), makeDipole(medium[1]), makeDipole(medium[2])};
}

GaussianFit fitWeights(const DipoleRgb& dipoles, std::span<const double> variances) {
  GaussianFit fit{{variances.begin(), variances.end()}, std::vector<glm::dvec3>(variances.size()), {}};
  for (int c = 0; c < 3; ++c) {
    const ChannelFit channel = fitChannel(dipoles[size_t(c)], variances);
    for (size_t i = 0; i < variances.size(); ++i) fit.weights[i][c] = channel.weights[i];
    fit.error[c] = std::sqrt(channel.squaredError);
  }
  return fit;
}

GaussianFit fitGaussians(const DipoleRgb& dipoles, int count) {
  assert(count >= 1 && count <= GaussianSum::kCount);
  const auto squaredError = [&](const std::vector<double>& logarithms) {
    const std::vector<double> variances = exponentials(logarithms);
    double sum = 0;
    for (const Dipole& dipole : dipoles) sum += fitChannel(dipole, variances).squaredError;
    return sum;
  };
  Minimum best{{}, 1e300};
  for (int attempt = 0; attempt < 6; ++attempt) {
    const Minimum found =
        findMinimum(squaredError, firstLogarithms(dipoles, count, attempt), {.evaluations = 200});
    if (found.value < best.value) best = found;
  }
  best = findMinimum(squaredError, best.place, {.step = 0.1});
  return fitWeights(dipoles, exponentials(best.place));
}

GaussianSum asSum(const GaussianFit& fit) {
  GaussianSum sum;
  const size_t missing = GaussianSum::kCount - fit.variances.size();
  for (size_t i = 0; i < sum.variances.size(); ++i) {
    sum.variances[i] = fit.variances[i < missing ? 0 : i - missing];
    if (i >= missing) sum.weights[i] = fit.weights[i - missing];
  }
  return sum;
}

glm::dvec3 energyDifference(const DipoleRgb& dipoles, const GaussianFit& fit) {
  constexpr int kSteps = 2000;  // of log r over the reach of what the fit and the dipole hold
  const double low = std::log(1e-3), high = std::log(1e3);
  glm::dvec3 sum(0);
  for (int i = 0; i < kSteps; ++i) {
    const double r = std::exp(low + (high - low) * (i + 0.5) / kSteps);
    for (int c = 0; c < 3; ++c) {
      double value = diffuseReflectance(dipoles[size_t(c)], r) / totalReflectance(dipoles[size_t(c)]);
      for (size_t g = 0; g < fit.variances.size(); ++g)
        value -= fit.weights[g][c] * std::exp(-r * r / (2 * fit.variances[g])) / (2 * kPi * fit.variances[g]);
      sum[c] += std::abs(value) * 2 * kPi * r * r * (high - low) / kSteps;
    }
  }
  return sum;
}

}  // namespace sonoskin
