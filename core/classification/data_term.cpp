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

void dataTermRow(const DataSource& source, int j, int k, float* diagonal, float* right) {
  const auto& [raw, lowPassed, o, levels] = source;
  const float w = float(o.rawShare), noise = float(o.noiseFloor * o.noiseFloor);
  const float alpha = float(o.alpha), gamma = float(o.gamma), delta = float(o.gradientFloor);
  const float perReference = float(1 / o.gradientReference), target = float(o.target);
  const float farthest = float(o.farthest * o.farthest);
  const float *v = &raw.at(0, j, k), *low = &lowPassed.at(0, j, k);
  squaredGradientRow(o.gradientSource == GradientSource::raw ? raw : lowPassed, j, k, right);
  const int count = raw.geometry.dims.x;
  thread_local std::vector<float> isoRow;
  isoRow.assign(std::size_t(count), float(o.isoValue));
  if (o.isoValue <= 0) levels.isoRow(o.isoShare, j, k, count, isoRow.data());
  const float* iso = isoRow.data();
#pragma omp simd
  for (int i = 0; i < count; ++i) {
    const float dv = v[i] - iso[i], dl = low[i] - iso[i], g2 = right[i];
    const float a = (w * dv * dv + (1 - w) * dl * dl + noise) / (g2 + kFlatGradient);
    const float h = gamma * (delta + (1 - delta) * std::min(1.0f, std::sqrt(g2) * perReference));
    diagonal[i] = alpha * std::min(a, farthest) + h;
    right[i] = h * target;
  }
}

DataTerm dataTerm(const DataSource& source, const Progress& progress) {
  const Geometry& geometry = source.raw.geometry;
  DataTerm term{LargeArray<float>(geometry.voxels()), LargeArray<float>(geometry.voxels())};
  parallelFor(
      geometry.dims.z,
      [&](std::ptrdiff_t k) {
        for (int j = 0; j < geometry.dims.y; ++j) {
          const std::size_t start = geometry.index(0, j, int(k));
          dataTermRow(source, j, int(k), &term.diagonal[start], &term.right[start]);
        }
      },
      progress);
  return term;
}

double absoluteBeta(const ClassificationOptions& o) {
  return o.beta * o.tangentialLength * o.tangentialLength * o.gamma * edgePull(o, 0.06);
}

double couplingLength(const ClassificationOptions& o) {
  double most = 0;
  for (double gradient = 1e-3; gradient < 2; gradient *= 1.1) {
    const double g2 = gradient * gradient;
    const double a =
        std::min(o.noiseFloor * o.noiseFloor / (g2 + double(kFlatGradient)), o.farthest * o.farthest);
    const double c = o.alpha * a + o.gamma * edgePull(o, gradient);
    most = std::max(most, absoluteBeta(o) * g2 / (g2 + o.directionScale * o.directionScale) / c);
  }
  return std::sqrt(most);
}

}  // namespace sonoskin
