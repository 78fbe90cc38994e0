#include "core/rbf/compact/local_quadric.h"

#include <cmath>

#include "core/rbf/basis.h"

namespace sonoskin {
namespace {

constexpr double kRelativePivot = 1e-10;

// Sums of w_j u^a v^b (named uab) and of w_j w u^a v^b (named wab), all lengths in units of σ.
struct Moments {
  float u40 = 0, u31 = 0, u22 = 0, u13 = 0, u04 = 0, u30 = 0, u21 = 0, u12 = 0, u03 = 0;
  float u20 = 0, u11 = 0, u02 = 0, u10 = 0, u01 = 0, u00 = 0;
  float w20 = 0, w11 = 0, w02 = 0, w10 = 0, w01 = 0, w00 = 0;
};

Moments sumMoments(const LocalSamples& s, float inverseSigma) {
  float u40 = 0, u31 = 0, u22 = 0, u13 = 0, u04 = 0, u30 = 0, u21 = 0, u12 = 0, u03 = 0;
  float u20 = 0, u11 = 0, u02 = 0, u10 = 0, u01 = 0, u00 = 0;
  float w20 = 0, w11 = 0, w02 = 0, w10 = 0, w01 = 0, w00 = 0;
  const float *su = s.u, *sv = s.v, *sw = s.w, *sr = s.r, *sd = s.d;
#pragma omp simd reduction(+ : u40, u31, u22, u13, u04, u30, u21, u12, u03, u20, u11, u02, u10, u01, u00, w20, \
                               w11, w02, w10, w01, w00)
  for (std::size_t j = 0; j < s.count; ++j) {
    const float weight = wendland(sr[j] * inverseSigma) * sd[j];
    const float u = su[j] * inverseSigma, v = sv[j] * inverseSigma, w = sw[j] * inverseSigma;
    const float pu = weight * u, pv = weight * v, puu = pu * u, puv = pu * v, pvv = pv * v;
    const float uu = u * u, vv = v * v, uv = u * v;
    u40 += puu * uu, u31 += puu * uv, u22 += puu * vv, u13 += pvv * uv, u04 += pvv * vv;
    u30 += puu * u, u21 += puu * v, u12 += pvv * u, u03 += pvv * v;
    u20 += puu, u11 += puv, u02 += pvv, u10 += pu, u01 += pv, u00 += weight;
    w20 += puu * w, w11 += puv * w, w02 += pvv * w, w10 += pu * w, w01 += pv * w, w00 += weight * w;
  }
  return {u40, u31, u22, u13, u04, u30, u21, u12, u03, u20, u11,
          u02, u10, u01, u00, w20, w11, w02, w10, w01, w00};
}

// Solves M x = b for a symmetric positive definite M given by its lower triangle; false if M is near
// singular.
template <std::size_t N>
bool solveCholesky(std::array<std::array<double, N>, N> M, std::array<double, N>& b) {
  for (std::size_t i = 0; i < N; ++i) {
    const double diagonal = M[i][i];
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = M[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= M[i][k] * M[j][k];
      if (i > j) {
        M[i][j] = sum / M[j][j];
      } else {
        if (!(sum > kRelativePivot * diagonal)) return false;
        M[i][i] = std::sqrt(sum);
      }
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= M[i][k] * b[k];
    b[i] /= M[i][i];
  }
  for (std::size_t i = N; i-- > 0;) {
    for (std::size_t k = i + 1; k < N; ++k) b[i] -= M[k][i] * b[k];
    b[i] /= M[i][i];
  }
  return true;
}

// The normal equations [Σ w V Vᵀ] a = Σ w w V for V = (u², 2uv, v², u, v, 1) [thesis 3.17], of samples of some weight
LocalQuadric solveQuadric(const Moments& m) {
  std::array<std::array<double, 6>, 6> M{};
  M[0] = {m.u40};
  M[1] = {2. * m.u31, 4. * m.u22};
  M[2] = {m.u22, 2. * m.u13, m.u04};
  M[3] = {m.u30, 2. * m.u21, m.u12, m.u20};
  M[4] = {m.u21, 2. * m.u12, m.u03, m.u11, m.u02};
  M[5] = {m.u20, 2. * m.u11, m.u02, m.u10, m.u01, m.u00};
  std::array<double, 6> a{m.w20, 2. * m.w11, m.w02, m.w10, m.w01, m.w00};
  if (solveCholesky(M, a)) return {a[0], a[1], a[2], a[3], a[4], a[5]};

  std::array<std::array<double, 3>, 3> P{};
  P[0] = {m.u20};
  P[1] = {m.u11, m.u02};
  P[2] = {m.u10, m.u01, m.u00};
  std::array<double, 3> p{m.w10, m.w01, m.w00};
  if (solveCholesky(P, p)) return {0, 0, 0, p[0], p[1], p[2]};
  return {0, 0, 0, 0, 0, double(m.w00) / double(m.u00)};
}

// Σ w_j (g/|∇g|)² with |∇g|² = 1 + (2Au + 2Bv + D)² + (2Bu + 2Cv + E)²
float sumSquaredDistances(const LocalSamples& s, float inverseSigma, const LocalQuadric& q, SlopeForm slope) {
  const auto A = float(q.A), B2 = float(2 * q.B), C = float(q.C), D = float(q.D), E = float(q.E),
             F = float(q.F), mixed = slope == SlopeForm::exact ? B2 : float(q.B);
  const float *su = s.u, *sv = s.v, *sw = s.w, *sr = s.r, *sd = s.d;
  float sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t j = 0; j < s.count; ++j) {
    const float weight = wendland(sr[j] * inverseSigma) * sd[j];
    const float u = su[j] * inverseSigma, v = sv[j] * inverseSigma, w = sw[j] * inverseSigma;
    const float g = w - (u * (A * u + B2 * v + D) + v * (C * v + E) + F);
    const float gu = 2 * A * u + mixed * v + D, gv = mixed * u + 2 * C * v + E;
    sum += weight * g * g / (1 + gu * gu + gv * gv);
  }
  return sum;
}

}  // namespace

Frame frameAround(const glm::vec3& normal) {
  const glm::vec3 size = glm::abs(normal);
  glm::vec3 axis(0);
  axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
  const glm::vec3 u = glm::normalize(glm::cross(normal, axis));
  return {u, glm::cross(normal, u), normal};
}

LocalFit fitQuadric(const LocalSamples& samples, double sigma, SlopeForm slope) {
  const auto inverseSigma = float(1 / sigma);
  const Moments m = sumMoments(samples, inverseSigma);
  if (!(m.u00 > 0)) return {};
  const LocalQuadric q = solveQuadric(m);
  const double sum = double(sumSquaredDistances(samples, inverseSigma, q, slope));
  return {{q.A / sigma, q.B / sigma, q.C / sigma, q.D, q.E, q.F * sigma},
          sum * sigma * sigma / double(m.u00)};
}

GlobalQuadric toGlobal(const LocalQuadric& q, const Frame& frame) {
  const glm::dvec3 u(frame.u), v(frame.v);
  const auto entry = [&](int i, int j) {
    return -(q.A * u[i] * u[j] + q.B * (u[i] * v[j] + v[i] * u[j]) + q.C * v[i] * v[j]);
  };
  const glm::dvec3 l = glm::dvec3(frame.normal) - q.D * u - q.E * v;
  return {float(entry(0, 0)),
          float(entry(1, 1)),
          float(entry(2, 2)),
          float(2 * entry(0, 1)),
          float(2 * entry(0, 2)),
          float(2 * entry(1, 2)),
          float(l.x),
          float(l.y),
          float(l.z),
          float(-q.F)};
}

}  // namespace sonoskin
