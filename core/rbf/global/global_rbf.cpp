#include "core/rbf/global/global_rbf.h"

#include "core/rbf/global/global_polynomial.h"
#include "core/rbf/global/global_system.h"

namespace sonoskin {
namespace {

Eigen::Map<const Eigen::VectorXd> vectorOf(const std::vector<double>& v) {
  return {v.data(), Eigen::Index(v.size())};
}

Sites one(const glm::dvec3& p) {
  Sites sites;
  sites.push_back(p);
  return sites;
}

}  // namespace

double GlobalRbf::value(const glm::dvec3& x) const { return values(one(x)).front(); }

glm::dvec3 GlobalRbf::gradient(const glm::dvec3& x) const {
  const glm::dvec3 u = parts_.frame.toUnit(x);
  const glm::dvec3 radial =
      kernelGradients(parts_.kernel, parts_.centres, vectorOf(parts_.weights), one(u)).front();
  return (radial + polynomialGradient(parts_.polynomial, u)) / parts_.frame.scale;
}

std::vector<double> GlobalRbf::values(const Sites& places, const Progress& progress) const {
  const Sites unit = toUnit(parts_.frame, places);
  const Eigen::VectorXd sums =
      kernelSums(parts_.kernel, parts_.centres, vectorOf(parts_.weights), unit, progress);
  std::vector<double> result(unit.size());
  for (std::size_t i = 0; i < unit.size(); ++i)
    result[i] = sums[Eigen::Index(i)] + polynomialValue(parts_.polynomial, unit[i]);
  return result;
}

}  // namespace sonoskin
