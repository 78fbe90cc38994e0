#include "core/classification/data_term.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr float kFlatGradient =
    1.5e-5f;  // (1/255)^2: the squared gradient of a single grey step of 8-bit data

double edgePull(const ClassificationOptions& o, double gradient) {
  return o.gradientFloor + (1 - o.gradientFloor) * std::min(1.0, gradient / o.gradientReference);
}

// The squared gradient of one row, 0 at the volume's border, per smallest spacing.
void squaredGradientRow(const Volume<float>& v, int j, int k, float* out) {
  const glm::ivec3 dims = v.geometry.dims;
  std::fill_n(out, dims.x, 0.0f);
  if (j == 0 || k == 0 || j == dims.y - 1 || k == dims.z - 1) return;
  const glm::vec3 scale = 0.5f * v.geometry.axisScale();
  const float* row = &v.at(0, j, k);
  const std::ptrdiff_t up = dims.x, plane = std::ptrdiff_t(v.geometry.index(0, 0, 1));
#pragma omp simd
  for (int i = 1; i < dims.x - 1; ++i) {
    const float gx = scale.x * (row[i + 1] - row[i - 1]), gy = scale.y * (row[i + up] - row[i - up]),
                gz = scale.z * (row[i + plane] - row[i - plane]);
    out[i] = gx * gx + gy * gy + gz * gz;
  }
}

}  // namespace

DataTerm dataTerm(const Volume<float>& raw, const Volume<float>& lowPassed, const ClassificationOptions& o,
                  const Progress& progress) {
  const Geometry& geometry = raw.geometry;
  DataTerm term{std::vector<float>(geometry.voxels()), std::vector<float>(geometry.voxels())};
  const float iso = float(o.isoValue), w = float(o.rawShare), noise = float(o.noiseFloor * o.noiseFloor);
  const float alpha = float(o.alpha), gamma = float(o.gamma), delta = float(o.gradientFloor);
  const float perReference = float(1 / o.gradientReference), target = float(o.target);
  const float farthest = float(o.farthest * o.farthest);
  const Volume<float>& edges = o.gradientSource == GradientSource::raw ? raw : lowPassed;
  parallelFor(
      geometry.dims.z,
      [&](std::ptrdiff_t k) {
        std::vector<float> gradient(std::size_t(geometry.dims.x));
        for (int j = 0; j < geometry.dims.y; ++j) {
          squaredGradientRow(edges, j, int(k), gradient.data());
          const std::size_t start = geometry.index(0, j, int(k));
          const float *v = &raw.data[start], *low = &lowPassed.data[start], *g2 = gradient.data();
          float *c = &term.diagonal[start], *b = &term.right[start];
#pragma omp simd
          for (int i = 0; i < geometry.dims.x; ++i) {
            const float dv = v[i] - iso, dl = low[i] - iso;
            const float a = (w * dv * dv + (1 - w) * dl * dl + noise) / (g2[i] + kFlatGradient);
            const float h = gamma * (delta + (1 - delta) * std::min(1.0f, std::sqrt(g2[i]) * perReference));
            c[i] = alpha * std::min(a, farthest) + h;
            b[i] = h * target;
          }
        }
      },
      progress);
  return term;
}

double absoluteBeta(const ClassificationOptions& o) {
  return o.beta * o.tangentialLength * o.tangentialLength * o.gamma * edgePull(o, 0.06);
}

}  // namespace sonoskin
