#include "core/skin/beckmann.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sonoskin {
namespace {

constexpr double kPi = std::numbers::pi;

// Gauss-Legendre nodes and weights on 0 .. 1.
template <size_t N>
struct Quadrature {
  std::array<double, N> node, weight;
  Quadrature() {
    for (size_t i = 0; i < N; ++i) {
      double x = std::cos(kPi * (double(i) + 0.75) / (N + 0.5)), slope = 1;
      for (int newton = 0; newton < 8; ++newton) {
        double p = 1, before = 0;
        for (size_t k = 1; k <= N; ++k) {
          const double next = ((2.0 * double(k) - 1) * x * p - (double(k) - 1) * before) / double(k);
          before = p, p = next;
        }
        slope = N * (x * p - before) / (x * x - 1);
        x -= p / slope;
      }
      node[i] = (1 - x) / 2;
      weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
  }
};

// One ring of facets, tilted so that tan = t: the mean of F n.l / (v.h n.h) around it, for directions l above
// the surface. v.h and n.l are linear in the azimuth's cosine; n.l > 0 cuts off the far part of the ring.
double ringMean(double cosine, double t, double f0) {
  static const Quadrature<20> rule;
  const double ch = 1 / std::sqrt(1 + t * t), sh = t * ch;
  const double middle = cosine * ch, swing = std::sqrt(1 - cosine * cosine) * sh;
  const double least = cosine / (2 * ch);  // v.h where l grazes the surface
  if (middle + swing <= least) return 0;
  const double edge = swing > 0 ? (least - middle) / swing : -1;
  const double reach = edge <= -1 ? kPi : std::acos(edge);
  double sum = 0;
  for (size_t i = 0; i < rule.node.size(); ++i) {
    const double vh = middle + swing * std::cos(reach * rule.node[i]);
    if (vh <= 0) continue;
    sum += rule.weight[i] * schlickFresnel(vh, f0) * (2 * vh * ch - cosine) / (vh * ch);
  }
  return sum * reach / kPi;
}

// The integral over rings between two slopes, t in units of m.
double rings(double cosine, double m, double f0, double from, double to) {
  static const Quadrature<20> rule;
  double sum = 0;
  for (size_t i = 0; i < rule.node.size(); ++i) {
    const double t = from + (to - from) * rule.node[i];
    sum += rule.weight[i] * 2 * t * std::exp(-t * t) * ringMean(cosine, m * t, f0);
  }
  return sum * (to - from);
}

}  // namespace

double beckmannDensity(double cosine, double m) {
  const double c2 = cosine * cosine;
  return std::exp((c2 - 1) / (c2 * m * m)) / (kPi * m * m * c2 * c2);
}

double schlickFresnel(double cosine, double f0) {
  const double x = 1 - cosine, x2 = x * x;
  return f0 + (1 - f0) * x2 * x2 * x;
}

double directionalAlbedo(double cosine, double m, double f0) {
  constexpr double kSteepest = 5;  // times m: exp(-25) of the facets are steeper
  const double c = std::clamp(cosine, 1e-3, 1.0);
  // Below this slope the whole ring sends light upward, above it a part: the integrand has a kink there.
  const double kink = std::tan((kPi / 2 - std::acos(c)) / 2) / m;
  const double middle = std::min(kink, kSteepest);
  return rings(c, m, f0, 0, middle) + (middle < kSteepest ? rings(c, m, f0, middle, kSteepest) : 0);
}

double meanAlbedo(double m) {
  static const Quadrature<24> rule;
  double sum = 0;
  for (size_t i = 0; i < rule.node.size(); ++i)
    sum += rule.weight[i] * 2 * rule.node[i] * directionalAlbedo(rule.node[i], m);
  return sum;
}

}  // namespace sonoskin
