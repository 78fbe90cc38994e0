#pragma once

#include <Eigen/QR>
#include <array>
#include <glm/glm.hpp>

#include "core/rbf/global/global_sites.h"

namespace sonoskin {

// monomialCount: 0, 1, 4, 10 for degree -1, 0, 1, 2.
int monomialCount(int degree);

// Monomials: 1; x, y, z; x², y², z², xy, yz, zx; those of a degree are the first monomialCount().
using Monomials = std::array<double, 10>;
Monomials monomials(const glm::dvec3& p);

// polynomialValue, polynomialGradient: of Σ c_k q_k at p; as many coefficients as the degree has.
double polynomialValue(const std::vector<double>& coefficients, const glm::dvec3& p);
glm::dvec3 polynomialGradient(const std::vector<double>& coefficients, const glm::dvec3& p);

// PolynomialSpace: the polynomials of a degree, as vectors of their values at some sites.
class PolynomialSpace {
 public:
  PolynomialSpace(const Sites& sites, int degree);

  // isComplete: no polynomial of the degree but 0 vanishes at all sites.
  bool isComplete() const { return rank_ == matrix_.cols(); }
  Eigen::Index rank() const { return rank_; }

  // project: takes the polynomial part out of v: afterwards Σ v_i q(x_i) = 0 for every polynomial q.
  void project(Eigen::VectorXd& v) const;

  // fit: the coefficients of the polynomial nearest to the values; takes it out of them.
  Eigen::VectorXd fit(Eigen::VectorXd& values) const;

 private:
  Eigen::MatrixXd matrix_;  // a column per monomial
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr_;
  Eigen::Index rank_ = 0;
  Eigen::MatrixXd orthonormal_;
};

// monomialMatrix: a row per site, a column per monomial.
Eigen::MatrixXd monomialMatrix(const Sites& sites, int degree);

}  // namespace sonoskin
