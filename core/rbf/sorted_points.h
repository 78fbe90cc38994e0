#pragma once

#include "core/base/progress.h"
#include "core/mesh/search/point_grid.h"
#include "core/rbf/reconstruction_options.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// SortedPoints: surface points made ready for the fit: sorted by cell, one array per component for vector
// code.
struct SortedPoints {
  PointGrid grid;
  std::vector<float> x, y, z;     // mm
  std::vector<float> nx, ny, nz;  // unit, outward
  std::vector<float> influence;   // d_i > 0; its scale cancels everywhere
  std::vector<float> noise;       // mm, along the normal; empty where it is not known
  double diagonal = 0;            // L: of the points' box, mm
  double spacing = 0;             // h: 1/sqrt(density), mm

  std::size_t size() const { return x.size(); }
  glm::vec3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

// checkPoints: what every fit asks of its points.
//   errors   Error: fewer than 12 points, a number that is not finite, a missing normal, a confidence <= 0,
//            all points on one line
void checkPoints(const SurfacePoints& points);

// sortPoints: checks the points, sorts them and measures their density.
//   errors   Error: see checkPoints; Cancelled
SortedPoints sortPoints(const SurfacePoints& points, const ReconstructionOptions& options,
                        const Progress& progress = {});

// kMinPointsInSupport: a quadric has 6 unknowns; with fewer than twice as many points its residual says
// nothing.
constexpr std::size_t kMinPointsInSupport = 12;

}  // namespace sonoskin
