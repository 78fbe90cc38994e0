#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "core/rbf/global/global_polynomial.h"
#include "core/rbf/global/global_solver.h"

namespace sonoskin::test {

constexpr std::array<GlobalBasis, 7> kAllBases{GlobalBasis::biharmonic,   GlobalBasis::triharmonic,
                                               GlobalBasis::thinPlate,    GlobalBasis::gaussian,
                                               GlobalBasis::multiquadric, GlobalBasis::inverseMultiquadric,
                                               GlobalBasis::wendland};

// randomSites: in the unit box, and points near a sphere in it if asked for.
inline Sites randomSites(int count, unsigned seed = 1, bool onSphere = false) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Sites sites;
  while (int(sites.size()) < count) {
    const glm::dvec3 p(uniform(random), uniform(random), uniform(random));
    const double length = glm::length(p);
    if (!onSphere) sites.push_back(p);
    if (onSphere && length > 0.1 && length < 1) sites.push_back((0.9 + 0.05 * uniform(random)) / length * p);
  }
  return sites;
}

inline Eigen::VectorXd randomVector(std::size_t count, unsigned seed = 2) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd v(count);
  for (double& x : v) x = normal(random);
  return v;
}

// valueAt: the function that a solution of a system stands for.
inline double valueAt(const GlobalSystem& system, const GlobalSolution& solution, const glm::dvec3& p) {
  double sum = polynomialValue({solution.polynomial.begin(), solution.polynomial.end()}, p);
  for (std::size_t i = 0; i < system.sites.size(); ++i) {
    const glm::dvec3 d = p - system.sites[i];
    sum += solution.weights[Eigen::Index(i)] * kernelValue(system.kernel, glm::dot(d, d));
  }
  return sum;
}

}  // namespace sonoskin::test
