#include "core/rbf/global/global_basis.h"

#include <cmath>

#include "core/rbf/global/global_kernels.h"

namespace sonoskin {

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

bool hasWidth(GlobalBasis basis) {
  return basis != GlobalBasis::biharmonic && basis != GlobalBasis::triharmonic &&
         basis != GlobalBasis::thinPlate;
}

double kernelVariation(const RadialKernel& kernel, double distance) {
  const double squared = distance * distance;
  if (kernel.basis == GlobalBasis::thinPlate) return squared;
  return std::abs(kernelValue(kernel, squared) - kernelValue(kernel, 0));
}

double kernelValue(const RadialKernel& kernel, double squared) {
  KernelChunk chunk = KernelChunk::Constant(1, squared);
  withKernel(kernel, [&](const auto& k) { k.value(chunk); });
  return chunk[0];
}

}  // namespace sonoskin
