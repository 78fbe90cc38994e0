#pragma once

#include <Eigen/Geometry>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/classification/classification_options.h"
#include "core/volume/volume.h"

namespace sonoskin::test {

// ThesisMatrix: the thesis' equation 3.7 as its program had it: volumes of the low-passed values, gradients and
// curls, a row of seven entries per voxel, an assembled sparse matrix.
template <class Real>
struct ThesisMatrix {
  Eigen::SparseMatrix<Real> a;
  Eigen::Matrix<Real, Eigen::Dynamic, 1> b;
};

template <class Real>
using Vectors = std::vector<Eigen::Matrix<Real, 3, 1>>;

// step: from a voxel to the next along an axis, in memory.
inline std::ptrdiff_t step(const Geometry& g, int axis) {
  return axis == 0   ? 1
         : axis == 1 ? std::ptrdiff_t(g.dims.x)
                     : std::ptrdiff_t(g.dims.x) * std::ptrdiff_t(g.dims.y);
}

// forEachVoxel: f(index of the voxel in memory, its indices).
template <class F>
void forEachVoxel(const Geometry& g, const F& f) {
  for (int k = 0; k < g.dims.z; ++k)
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) f(g.index(i, j, k), glm::ivec3(i, j, k));
}

inline bool onBorder(const Geometry& g, const glm::ivec3& p) {
  return glm::any(glm::equal(p, glm::ivec3(0))) || glm::any(glm::equal(p, g.dims - 1));
}

template <class Real>
std::vector<Real> boxMeans(const Volume<float>& v) {
  const Geometry& g = v.geometry;
  std::vector<Real> means(g.voxels());
  forEachVoxel(g, [&](std::size_t index, const glm::ivec3& p) {
    Real sum = 0;
    for (int dk = -1; dk <= 1; ++dk)
      for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
          const glm::ivec3 q = glm::clamp(p + glm::ivec3(di, dj, dk), glm::ivec3(0), g.dims - 1);
          sum += Real(v.at(q.x, q.y, q.z));
        }
    means[index] = sum / 27;
  });
  return means;
}

// Central differences along each axis where both neighbours are there, else 0.
template <class Real, class Values>
Vectors<Real> gradients(const Geometry& g, const Values& v) {
  Vectors<Real> result(g.voxels(), Eigen::Matrix<Real, 3, 1>::Zero());
  forEachVoxel(g, [&](std::size_t index, const glm::ivec3& p) {
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] > 0 && p[axis] < g.dims[axis] - 1)
        result[index][axis] = (Real(v[std::size_t(std::ptrdiff_t(index) + step(g, axis))]) -
                               Real(v[std::size_t(std::ptrdiff_t(index) - step(g, axis))])) /
                              2;
  });
  return result;
}

// The curl of a vector field, 0 in the outermost voxels.
template <class Real>
Vectors<Real> curls(const Geometry& g, const Vectors<Real>& field, CurlDifferences differences) {
  Vectors<Real> result(g.voxels(), Eigen::Matrix<Real, 3, 1>::Zero());
  forEachVoxel(g, [&](std::size_t index, const glm::ivec3& p) {
    if (onBorder(g, p)) return;
    const auto along = [&](int axis, int component) {
      const auto value = [&](std::ptrdiff_t n) {
        return field[std::size_t(std::ptrdiff_t(index) + n * step(g, axis))][component];
      };
      return differences == CurlDifferences::forward ? value(1) - value(0) : (value(1) - value(-1)) / 2;
    };
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      result[index][c] = along(d, e) - along(e, d);
    }
  });
  return result;
}

// thesisMatrix: assembles the system. About 2 GB for 8 million voxels of floats.
template <class Real>
ThesisMatrix<Real> thesisMatrix(const Volume<float>& v, const ClassificationOptions& o) {
  const Geometry& g = v.geometry;
  const std::vector<Real> low = boxMeans<Real>(v);
  const Vectors<Real> rawGradient = gradients<Real>(g, v.data), gradient = gradients<Real>(g, low);
  const Vectors<Real> curl = curls<Real>(g, gradient, o.curl);
  std::vector<Eigen::Triplet<Real>> entries;
  entries.reserve(7 * g.voxels());
  ThesisMatrix<Real> system;
  system.b.resize(Eigen::Index(g.voxels()));
  forEachVoxel(g, [&](std::size_t index, const glm::ivec3& p) {
    const int row = int(index);
    const Real iso = Real(o.isoValue), w = Real(o.rawShare), dv = Real(v.data[index]) - iso,
               dl = low[index] - iso;
    const Real size = onBorder(g, p) ? 0 : rawGradient[index].norm();
    const Real a =
        (w * dv * dv + (1 - w) * dl * dl) / (size * size + Real(std::numeric_limits<float>::epsilon()));
    const Real pull = Real(o.gamma) * (Real(o.gradientFloor) + (1 - Real(o.gradientFloor)) * size);
    entries.emplace_back(row, row, Real(o.alpha) * a + pull);
    system.b[row] = pull * Real(o.target);
    if (onBorder(g, p)) return;
    const Eigen::Matrix<Real, 3, 1> c = Real(o.beta) * gradient[index].cross(curl[index]) / 2;
    for (int axis = 0; axis < 3; ++axis) {
      entries.emplace_back(row, row + int(step(g, axis)), c[axis]);
      entries.emplace_back(row, row - int(step(g, axis)), -c[axis]);
    }
  });
  system.a.resize(system.b.size(), system.b.size());
  system.a.setFromTriplets(entries.begin(), entries.end());
  return system;
}

}  // namespace sonoskin::test
