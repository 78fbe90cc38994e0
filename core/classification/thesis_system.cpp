#include "core/classification/thesis_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/classification/skew_system.h"
#include "core/volume/box_blur.h"

namespace sonoskin {
namespace {

constexpr float kEpsilon = std::numeric_limits<float>::epsilon();

struct Extremes {
  float least = std::numeric_limits<float>::infinity(), greatest = -least;
  void join(const Extremes& other) {
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
  }
};

std::size_t sliceSize(const Geometry& g) { return g.index(0, 0, 1); }

Extremes extremesOf(const float* values, std::size_t count) {
  float least = values[0], greatest = values[0];
#pragma omp simd reduction(min : least) reduction(max : greatest)
  for (std::size_t i = 0; i < count; ++i) {
    least = values[i] < least ? values[i] : least;
    greatest = values[i] > greatest ? values[i] : greatest;
  }
  return {least, greatest};
}

// |grad v|^2 of one row in unit spacing, 0 in the outermost layer.
void squaredGradientRow(const Volume<float>& v, int j, int k, float* out) {
  const glm::ivec3 dims = v.geometry.dims;
  std::fill_n(out, dims.x, 0.0f);
  if (j == 0 || k == 0 || j == dims.y - 1 || k == dims.z - 1) return;
  const float* row = &v.at(0, j, k);
  const std::ptrdiff_t up = dims.x, plane = std::ptrdiff_t(sliceSize(v.geometry));
#pragma omp simd
  for (int i = 1; i < dims.x - 1; ++i) {
    const float gx = row[i + 1] - row[i - 1], gy = row[i + up] - row[i - up],
                gz = row[i + plane] - row[i - plane];
    out[i] = 0.25f * (gx * gx + gy * gy + gz * gz);
  }
}

// The closed form for slice k. Every row is made of rows of v alone, so that v is read and u written once.
void closedSlice(const Volume<float>& v, const ClassificationOptions& o, int k, Volume<float>& u) {
  const std::size_t n = std::size_t(v.geometry.dims.x);
  std::vector<float> scratch(5 * n + 2);
  float* low = scratch.data() + n + 2;
  const ThesisRow row{low + n, low + 2 * n, low + 3 * n};
  for (int j = 0; j < v.geometry.dims.y; ++j) {
    boxBlurRow(v, j, k, scratch.data(), low);
    thesisRow(v, low, j, k, o, row);
    float* out = &u.at(0, j, k);
#pragma omp simd
    for (std::size_t i = 0; i < n; ++i) out[i] = row.diagonal[i] > 0 ? row.right[i] / row.diagonal[i] : 0;
  }
}

Volume<float> closedForm(const Volume<float>& volume, const ClassificationOptions& options,
                         const Progress& progress) {
  Volume<float> u;
  u.geometry = volume.geometry;
  u.data.resize(volume.geometry.voxels());
  parallelFor(
      volume.geometry.dims.z, [&](std::ptrdiff_t k) { closedSlice(volume, options, int(k), u); }, progress);
  return u;
}

// forEachSlice: body(first value, number of values, k) for every slice, in parallel.
template <class Body>
void forEachSlice(Volume<float>& u, const Progress& progress, const Body& body) {
  const std::size_t slice = sliceSize(u.geometry);
  parallelFor(
      u.geometry.dims.z, [&](std::ptrdiff_t k) { body(u.data.data() + std::size_t(k) * slice, slice, k); },
      progress);
}

// u brought to [0, 1] by its least and greatest value; a u that is the same everywhere stays as it is.
void rescaleToUnit(Volume<float>& u, const Progress& progress) {
  std::vector<Extremes> perSlice(std::size_t(u.geometry.dims.z));
  forEachSlice(u, progress.part(0, 0.5), [&](const float* values, std::size_t count, std::ptrdiff_t k) {
    perSlice[std::size_t(k)] = extremesOf(values, count);
  });
  Extremes all;
  for (const Extremes& e : perSlice) all.join(e);
  if (!(all.least < all.greatest)) return;
  const float factor = 1 / (all.greatest - all.least);
  forEachSlice(u, progress.part(0.5, 1), [&](float* values, std::size_t count, std::ptrdiff_t) {
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) values[i] = std::min(1.0f, (values[i] - all.least) * factor);
  });
}

void clampTo(Volume<float>& u, float target, const Progress& progress) {
  forEachSlice(u, progress, [&](float* values, std::size_t count, std::ptrdiff_t) {
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) values[i] = std::min(std::max(values[i], 0.0f), target);
  });
}

}  // namespace

void thesisRow(const Volume<float>& volume, const float* lowPassed, int j, int k,
               const ClassificationOptions& o, const ThesisRow& out) {
  squaredGradientRow(volume, j, k, out.edge);
  const float iso = float(o.isoValue), w = float(o.rawShare), alpha = float(o.alpha), gamma = float(o.gamma);
  const float delta = float(o.gradientFloor), target = float(o.target);
  const float* v = &volume.at(0, j, k);
  float *diagonal = out.diagonal, *right = out.right, *edge = out.edge;
#pragma omp simd
  for (int i = 0; i < volume.geometry.dims.x; ++i) {
    const float dv = v[i] - iso, dl = lowPassed[i] - iso;
    const float h = gamma * (delta + (1 - delta) * std::sqrt(edge[i]));
    edge[i] += kEpsilon;
    diagonal[i] = alpha * (w * dv * dv + (1 - w) * dl * dl) + h * edge[i];
    right[i] = h * target * edge[i];
  }
}

Volume<float> classifyThesis(const Volume<float>& volume, const ClassificationOptions& options,
                             const Progress& progress) {
  const glm::ivec3 dims = volume.geometry.dims;
  require(glm::min(dims.x, glm::min(dims.y, dims.z)) >= 3,
          "the volume has {}x{}x{} voxels: surfaces need at least 3 along each axis", dims.x, dims.y, dims.z);
  const bool skew = options.formulation == Formulation::thesisSkew;
  Volume<float> u = skew ? solveSkewSystem(volume, options, progress.part(0, 0.9)).u
                         : closedForm(volume, options, progress.part(0, 0.6));
  const Progress last = progress.part(skew ? 0.9 : 0.6, 1);
  if (options.rescale) {
    rescaleToUnit(u, last);
  } else if (skew) {
    clampTo(u, float(options.target), last);
  }
  last.update(1);
  return u;
}

}  // namespace sonoskin
