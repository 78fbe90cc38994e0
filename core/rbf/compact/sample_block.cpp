#include "core/rbf/compact/sample_block.h"

#include <cmath>

#include "core/rbf/basis.h"

namespace sonoskin {

// Sums over centres are most of the work of a surface: where the machine has wider vectors they are used. Each place's
// sum is the same whatever the width.
[[gnu::target_clones("default", "arch=x86-64-v4")]] void addCentre(const Centre& centre,
                                                                   const glm::vec3& offset,
                                                                   SampleBlock& block) {
  const GlobalQuadric q = centre.quadric;
  const float inverse = 1 / centre.support, lambda = centre.lambda, ox = offset.x, oy = offset.y,
              oz = offset.z;
  const float *px = block.x.data(), *py = block.y.data(), *pz = block.z.data();
  float *coverage = block.coverage.data(), *weighted = block.weighted.data();
#pragma omp simd
  for (std::size_t i = 0; i < block.count; ++i) {
    const float x = px[i] + ox, y = py[i] + oy, z = pz[i] + oz;
    const float phi = wendland(std::sqrt(x * x + y * y + z * z) * inverse);
    coverage[i] += phi;
    weighted[i] += phi * (q.value(x, y, z) + lambda);
  }
}

[[gnu::target_clones("default", "arch=x86-64-v4")]] void addCentre(const Centre& centre,
                                                                   const glm::vec3& offset,
                                                                   GradientBlock& block) {
  const GlobalQuadric q = centre.quadric;
  const float inverse = 1 / centre.support, lambda = centre.lambda, ox = offset.x, oy = offset.y,
              oz = offset.z;
  const float *px = block.x.data(), *py = block.y.data(), *pz = block.z.data();
  float *gx = block.gx.data(), *gy = block.gy.data(), *gz = block.gz.data();
#pragma omp simd
  for (std::size_t i = 0; i < block.count; ++i) {
    const float x = px[i] + ox, y = py[i] + oy, z = pz[i] + oz;
    const float t = std::sqrt(x * x + y * y + z * z) * inverse;
    const float phi = wendland(t);
    const float slope = (q.value(x, y, z) + lambda) * wendlandGradientFactor(t) * inverse * inverse;
    gx[i] += phi * (2 * q.xx * x + q.xy * y + q.xz * z + q.lx) + slope * x;
    gy[i] += phi * (2 * q.yy * y + q.xy * x + q.yz * z + q.ly) + slope * y;
    gz[i] += phi * (2 * q.zz * z + q.xz * x + q.yz * y + q.lz) + slope * z;
  }
}

}  // namespace sonoskin
