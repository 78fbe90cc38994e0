#include "core/rbf/global/global_polynomial.h"

namespace sonoskin {
namespace {

constexpr double kRankThreshold = 1e-9;  // sites in float have about 1e-7 of noise in a unit box

}  // namespace

int monomialCount(int degree) { return (degree + 1) * (degree + 2) * (degree + 3) / 6; }

Monomials monomials(const glm::dvec3& p) {
  return {1, p.x, p.y, p.z, p.x * p.x, p.y * p.y, p.z * p.z, p.x * p.y, p.y * p.z, p.z * p.x};
}

double polynomialValue(const std::vector<double>& coefficients, const glm::dvec3& p) {
  const Monomials q = monomials(p);
  double sum = 0;
  for (std::size_t k = 0; k < coefficients.size(); ++k) sum += coefficients[k] * q[k];
  return sum;
}

glm::dvec3 polynomialGradient(const std::vector<double>& coefficients, const glm::dvec3& p) {
  const std::array<glm::dvec3, 10> q{{{0, 0, 0},
                                      {1, 0, 0},
                                      {0, 1, 0},
                                      {0, 0, 1},
                                      {2 * p.x, 0, 0},
                                      {0, 2 * p.y, 0},
                                      {0, 0, 2 * p.z},
                                      {p.y, p.x, 0},
                                      {0, p.z, p.y},
                                      {p.z, 0, p.x}}};
  glm::dvec3 sum(0);
  for (std::size_t k = 0; k < coefficients.size(); ++k) sum += coefficients[k] * q[k];
  return sum;
}

Eigen::MatrixXd monomialMatrix(const Sites& sites, int degree) {
  Eigen::MatrixXd matrix(sites.size(), monomialCount(degree));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Monomials q = monomials(sites[std::size_t(i)]);
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) matrix(i, k) = q[std::size_t(k)];
  }
  return matrix;
}

PolynomialSpace::PolynomialSpace(const Sites& sites, int degree) : matrix_(monomialMatrix(sites, degree)) {
  if (matrix_.cols() == 0) return;
  qr_.setThreshold(kRankThreshold);
  qr_.compute(matrix_);
  rank_ = qr_.rank();
  orthonormal_ = Eigen::MatrixXd::Identity(matrix_.rows(), rank_);
  orthonormal_.applyOnTheLeft(qr_.householderQ());
}

void PolynomialSpace::project(Eigen::VectorXd& v) const {
  if (rank_ > 0) v -= orthonormal_ * (orthonormal_.transpose() * v);
}

Eigen::VectorXd PolynomialSpace::fit(Eigen::VectorXd& values) const {
  if (rank_ == 0) return Eigen::VectorXd::Zero(matrix_.cols());
  const Eigen::VectorXd coefficients = qr_.solve(values);
  values -= matrix_ * coefficients;
  return coefficients;
}

}  // namespace sonoskin
