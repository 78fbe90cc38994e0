#include "core/rbf/global_basis.h"

#include <cmath>

#include "core/rbf/global_kernels.h"

namespace sonoskin {
namespace {

// The power p with φ(s r) = s^p φ(r), up to polynomials that the side conditions cancel.
int homogeneity(GlobalBasis basis) {
  switch (basis) {
    case GlobalBasis::biharmonic:
      return 1;
    case GlobalBasis::triharmonic:
      return 3;
    case GlobalBasis::thinPlate:
      return 2;
    default:
      return 0;  // the width is scaled instead
  }
}

}  // namespace

int minimumDegree(GlobalBasis basis) {
  switch (basis) {
    case GlobalBasis::biharmonic:
    case GlobalBasis::multiquadric:
      return 0;
    case GlobalBasis::triharmonic:
    case GlobalBasis::thinPlate:
      return 1;
    default:
      return -1;
  }
}

bool hasWidth(GlobalBasis basis) { return homogeneity(basis) == 0; }

double diagonalFactor(GlobalBasis basis, double scale) { return std::pow(scale, -homogeneity(basis)); }

double kernelValue(const RadialKernel& kernel, double squared) {
  KernelChunk chunk = KernelChunk::Constant(1, squared);
  withKernel(kernel, [&](const auto& k) { k.value(chunk); });
  return chunk[0];
}

double kernelSlope(const RadialKernel& kernel, double squared) {
  KernelChunk chunk = KernelChunk::Constant(1, squared);
  withKernel(kernel, [&](const auto& k) { k.slope(chunk); });
  return chunk[0];
}

}  // namespace sonoskin
