#pragma once

#include "core/base/progress.h"
#include "core/surface/surface_points.h"
#include "core/volume/volume.h"

namespace sonoskin {

// EdgeProfile: the grey across the surface, the mean over its points, each at its own steepest rise.
//   dark, bright   grey before the rise and behind it, in [0, 1]
//   steepest       grey at the steepest rise
//   width          mm in which the grey rises from 20 to 80 % of the way, without what the voxels' size adds
//   shift          mm that the points had to be moved inward to the steepest rise, their median
//   depth          mm that the skin is taken to lie behind it
struct EdgeProfile {
  double dark = 0, bright = 0, steepest = 0, width = 0, shift = 0, depth = 0;
};

// placeOnEdges: moves every point along its normal to where the grey rises most steeply, and from there by `depthShare`
// of the edge's width inward, onto the skin; and measures the noise of its place.
//   points    on the outer flank of the echo or near it, normals outward; `noise` is filled: standard deviation of one
//             point's place, mm
//   volume    the recorded one, not low-passed
//   output    the mean profile; all zero, and the points as they were, where the grey rises nowhere
//   method    The slope of the grey along each normal (derivative of a Gaussian of one smallest spacing) is averaged over
//             the neighbours within two voxels' size, 1.5 mm at least, on the same side, each shifted to its own depth;
//             its greatest value is the edge [Canny 1986: the maximum of the gradient along it], weighed by a Gaussian of
//             2 mm around the edge of the mean profile, so that bone behind the skin does not win. A place that differs
//             from the median of its neighbours' by more than 0.5 mm is taken from that. The noise is how much the places
//             of single slopes scatter around the averaged ones (1.48 times the median deviation around).
//   depth     Onto the skin (moveOntoSkin). The echo of an interface starts before it, by the length of the pulse and the
//             width of the beam; the wider the edge, the farther. The share is calibrated on the simulated scans, where the
//             skin is known.
//   cost      50,000 points: 0.15 s of one core
//   errors    Cancelled
//   threads   the result does not depend on their number
EdgeProfile placeOnEdges(SurfacePoints& points, const Volume<float>& volume, double depthShare,
                         const Progress& progress = {});

}  // namespace sonoskin
