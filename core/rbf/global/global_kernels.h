#pragma once

#include <Eigen/Core>

#include "core/rbf/global/global_basis.h"

namespace sonoskin {

// KernelChunk: squared distances r², turned in place into φ(r) or φ'(r)/r, in vector code.
constexpr std::size_t kKernelChunk = 64;
using KernelChunk = Eigen::Array<double, Eigen::Dynamic, 1, 0, int(kKernelChunk), 1>;

namespace kernels {

constexpr double kTiny = 1e-300;  // in place of r = 0, where a slope is multiplied by a vector of length zero

struct Biharmonic {
  void value(KernelChunk& c) const { c = -c.sqrt(); }
  void slope(KernelChunk& c) const { c = -c.max(kTiny).sqrt().inverse(); }
};

struct Triharmonic {
  void value(KernelChunk& c) const { c *= c.sqrt(); }
  void slope(KernelChunk& c) const { c = 3 * c.sqrt(); }
};

struct ThinPlate {
  void value(KernelChunk& c) const { c *= 0.5 * c.max(kTiny).log(); }
  void slope(KernelChunk& c) const { c = c.max(kTiny).log() + 1; }
};

struct Gaussian {
  double c2;  // 1/width²
  void value(KernelChunk& c) const { c = (-c2 * c).exp(); }
  void slope(KernelChunk& c) const { c = -2 * c2 * (-c2 * c).exp(); }
};

struct Multiquadric {
  double c2;
  void value(KernelChunk& c) const { c = -(1 + c2 * c).sqrt(); }
  void slope(KernelChunk& c) const { c = -c2 * (1 + c2 * c).sqrt().inverse(); }
};

struct InverseMultiquadric {
  double c2;
  void value(KernelChunk& c) const { c = (1 + c2 * c).sqrt().inverse(); }
  void slope(KernelChunk& c) const {
    value(c);
    c *= -c2 * c.square();
  }
};

struct Wendland {
  double c2;
  void value(KernelChunk& c) const {
    c = (c2 * c).sqrt().min(1.0);
    c = (1 - c).square().square() * (4 * c + 1);
  }
  void slope(KernelChunk& c) const {
    c = 1 - (c2 * c).sqrt().min(1.0);
    c *= -20 * c2 * c.square();
  }
};

}  // namespace kernels

// withKernel: calls f with the kernel's own type, so that loops over many distances are compiled for it.
template <class F>
auto withKernel(const RadialKernel& kernel, F&& f) {
  const double c2 = 1 / (kernel.width * kernel.width);
  switch (kernel.basis) {
    case GlobalBasis::biharmonic:
      return f(kernels::Biharmonic{});
    case GlobalBasis::triharmonic:
      return f(kernels::Triharmonic{});
    case GlobalBasis::thinPlate:
      return f(kernels::ThinPlate{});
    case GlobalBasis::gaussian:
      return f(kernels::Gaussian{c2});
    case GlobalBasis::multiquadric:
      return f(kernels::Multiquadric{c2});
    case GlobalBasis::inverseMultiquadric:
      return f(kernels::InverseMultiquadric{c2});
    case GlobalBasis::wendland:
      break;
  }
  return f(kernels::Wendland{c2});
}

}  // namespace sonoskin
