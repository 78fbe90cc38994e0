#include "core/skin/nelder_mead.h"

#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

using Point = std::vector<double>;
using Function = std::function<double(const Point&)>;

// from + t (to - from)
Point along(const Point& from, const Point& to, double t) {
  Point place(from.size());
  for (size_t i = 0; i < from.size(); ++i) place[i] = from[i] + t * (to[i] - from[i]);
  return place;
}

std::vector<Minimum> firstSimplex(const Function& function, const Point& start, double step) {
  std::vector<Minimum> simplex{{start, function(start)}};
  for (size_t i = 0; i < start.size(); ++i) {
    Point corner = start;
    corner[i] += step;
    simplex.push_back({corner, function(corner)});
  }
  return simplex;
}

// The middle of all corners but the last.
Point middleOfBest(const std::vector<Minimum>& simplex) {
  Point middle(simplex[0].place.size(), 0.0);
  for (size_t c = 0; c + 1 < simplex.size(); ++c)
    for (size_t i = 0; i < middle.size(); ++i) middle[i] += simplex[c].place[i] / double(simplex.size() - 1);
  return middle;
}

// One step: the worst corner, the last, is mirrored, stretched or pulled in, or all are drawn to the best.
// Gives the number of evaluations.
int improve(const Function& function, std::vector<Minimum>& simplex) {
  Minimum& worst = simplex.back();
  const Point middle = middleOfBest(simplex);
  const auto at = [&](double t) {
    Point place = along(middle, worst.place, t);
    const double value = function(place);
    return Minimum{std::move(place), value};
  };
  const Minimum mirrored = at(-1);
  if (mirrored.value < simplex[0].value) {
    const Minimum further = at(-2);
    worst = further.value < mirrored.value ? further : mirrored;
    return 2;
  }
  if (mirrored.value < simplex[simplex.size() - 2].value) {
    worst = mirrored;
    return 1;
  }
  const Minimum nearer = at(mirrored.value < worst.value ? -0.5 : 0.5);
  if (nearer.value < std::min(mirrored.value, worst.value)) {
    worst = nearer;
    return 2;
  }
  for (size_t c = 1; c < simplex.size(); ++c) {
    simplex[c].place = along(simplex[0].place, simplex[c].place, 0.5);
    simplex[c].value = function(simplex[c].place);
  }
  return 2 + int(simplex.size()) - 1;
}

}  // namespace

Minimum findMinimum(const Function& function, const Point& start, const NelderMeadOptions& options) {
  std::vector<Minimum> simplex = firstSimplex(function, start, options.step);
  const auto byValue = [](const Minimum& a, const Minimum& b) { return a.value < b.value; };
  int evaluations = int(simplex.size());
  while (true) {
    std::stable_sort(simplex.begin(), simplex.end(), byValue);
    const double spread = simplex.back().value - simplex[0].value;
    if (evaluations >= options.evaluations || spread <= options.tolerance * std::abs(simplex[0].value)) break;
    evaluations += improve(function, simplex);
  }
  return simplex[0];
}

}  // namespace sonoskin
