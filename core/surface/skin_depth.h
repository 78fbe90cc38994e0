#pragma once

#include "core/base/progress.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// moveOntoSkin: moves points from the edges of the grey onto the skin, which lies behind them.
//   points   on the steepest rise, normals outward; normals stay as they are
//   depth    mm inward, >= 0; where the body is thinner than four times that, at most a quarter of its thickness: else the two
//            sides of a finger would meet
//   method   along normals averaged over 1.5 mm, for every wrinkle would grow deeper along its own
//   cost     50,000 points: 0.1 s of one core
//   errors   Cancelled
//   threads  the result does not depend on their number
void moveOntoSkin(SurfacePoints& points, float depth, const Progress& progress = {});

}  // namespace sonoskin
