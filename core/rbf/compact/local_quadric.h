#pragma once

#include <array>
#include <glm/glm.hpp>

namespace sonoskin {

// Frame: an orthonormal frame with the surface's normal as third axis.
struct Frame {
  glm::vec3 u{1, 0, 0}, v{0, 1, 0}, normal{0, 0, 1};
};

// frameAround: a frame whose third axis is the unit vector `normal`. Defined for every direction.
Frame frameAround(const glm::vec3& normal);

// LocalSamples: points around a centre, in its frame; mm.
//   u, v, w   coordinates along the frame's axes, relative to the centre
//   r         distance from the centre
//   d         influence
struct LocalSamples {
  const float *u = nullptr, *v = nullptr, *w = nullptr, *r = nullptr, *d = nullptr;
  std::size_t count = 0;
};

// LocalQuadric: g(u,v,w) = w - (A u² + 2B uv + C v² + D u + E v + F), mm; close to the distance from its zero
// set.
struct LocalQuadric {
  double A = 0, B = 0, C = 0, D = 0, E = 0, F = 0;
};

struct LocalFit {
  LocalQuadric quadric;
  double meanSquare = 0;  // Σ w_j (g/|∇g|)² / Σ w_j: mean squared distance of the points, mm²
};

// SlopeForm: how |∇g| takes the mixed term 2B uv of g.
//   exact     its derivatives are 2B v and 2B u
//   printed   B v and B u, as the thesis' program has them; only to repeat its figures
enum class SlopeForm { exact, printed };

// fitQuadric: the quadric closest to the samples within the support.
//   sigma    support, mm; samples at r >= sigma do not count
//   solves   min Σ_j w_j g(p_j)², w_j = d_j φ(r_j/σ)             [thesis 3.16 with its missing square, 3.17]
//   method   coordinates scaled by 1/σ, 21 sums in float, 6x6 Cholesky in double; if singular a plane, then a
//            constant
//   cost     O(count); 40 operations per sample, vector code
LocalFit fitQuadric(const LocalSamples& samples, double sigma, SlopeForm slope = SlopeForm::exact);

// GlobalQuadric: the same function of x = position - centre in world axes: g = xᵀQx + l·x + f. Cheaper to
// evaluate.
struct GlobalQuadric {
  float xx = 0, yy = 0, zz = 0;  // Q's diagonal
  float xy = 0, xz = 0, yz = 0;  // twice Q's off-diagonals
  float lx = 0, ly = 0, lz = 0, f = 0;

  float value(float x, float y, float z) const {
    return x * (xx * x + xy * y + xz * z + lx) + y * (yy * y + yz * z + ly) + z * (zz * z + lz) + f;
  }
  glm::vec3 gradient(float x, float y, float z) const {
    return {2 * xx * x + xy * y + xz * z + lx, 2 * yy * y + xy * x + yz * z + ly,
            2 * zz * z + xz * x + yz * y + lz};
  }
};

GlobalQuadric toGlobal(const LocalQuadric& quadric, const Frame& frame);

}  // namespace sonoskin
