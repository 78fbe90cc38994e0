#pragma once

#include <cstdint>
#include <functional>

#include "core/rbf/compact/centres.h"

namespace sonoskin {

// thesisPoints: the points with the thesis' influences: 19 neighbours, for its twentieth is the point itself, no
// confidence, divided by their mean.                                                              [thesis 3.11]
//   errors   as sortPoints
SortedPoints thesisPoints(const SurfacePoints& points, const Progress& progress = {});

// thesisMinimum: the thesis' search for the first minimum: ten equal steps, at the first rise the two before it
// again in ten, and so on until the interval is below `tolerance`.                         [thesis, after 3.20]
//   error    sampled in [smallest, largest]
double thesisMinimum(const std::function<double(double sigma)>& error, double smallest, double largest,
                     double tolerance);

// selectThesisCentres: the centres as the thesis' program finds them, to compare.
//   search     supports of 0.0001 to 0.07 times the longest axis of the points' box, to 1e-7 L
//   frame      along the point's own normal; |∇g| with B where 2B is right (SlopeForm::printed)
//   selection  always the point of least overlap, from a queue; the program sorts all points again after every centre,
//              with the same outcome
//   ours       an orthonormal frame for every normal (its own is not defined for one), and supports with too few points
//              for a quadric get a plane
//   cost       32 to 45 fits per centre, one thread; 113k points: 0.3 to 0.7 s
//   errors     Cancelled
CentreSelection selectThesisCentres(const SortedPoints& points, const ReconstructionOptions& options,
                                    const Progress& progress = {});

}  // namespace sonoskin
