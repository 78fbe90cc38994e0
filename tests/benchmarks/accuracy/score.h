#pragma once

#include "core/surface/surface_points.h"
#include "tests/benchmarks/accuracy/truth.h"

namespace sonoskin::accuracy {

// Found: how many of the points are right, and how much of what could be found was found.
//   precision  share of the points within the radius of any fluid-tissue surface (truth.h)
//   recall     share of the visible skin that has a point within the radius
struct Found {
  double precision = 0, recall = 0;
  double f() const { return precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0; }
};

// Score: a method's points against the truth; raw: where they are, debiased: after the method's median offset was
// taken back along each point's normal.
struct Score {
  std::size_t points = 0;
  Found raw15, raw3, debiased15, debiased3;  // at 1.5 and at 3 voxels
  double offsetVoxels = 0, offsetMm = 0;     // medians over the visible skin, positive outside
  double residual = 0;  // RMS, voxels, of the debiased points within 3 voxels of the visible skin
};

Score scorePoints(const SurfacePoints& points, const Truth& truth);

}  // namespace sonoskin::accuracy
