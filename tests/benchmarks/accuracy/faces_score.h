#pragma once

#include <limits>

#include "core/mesh/mesh.h"
#include "tests/benchmarks/accuracy/faces_truth.h"

namespace sonoskin::accuracy {

// FaceScore: one mesh against the true skin of one simulated baby. kUnknown where there is nothing to measure.
//
// All but the spurs are sums over places spread evenly over a surface, 0.5 mm apart, so that the size of the triangles
// does not count. A place of the mesh is
//   foreign    farther than 3 mm from any skin of the baby, seen or not
//   of the visible baby    not foreign, and the nearest place of the truth is one that the probe sees
//   near the border    nearer than 3 mm, straight, to an edge with a triangle on one side only (the sides of holes too)
//
//   rms, p95, max, offset    distances in mm from the places of the visible baby to the truth; offset: the median of the
//                     signed ones, positive outside the baby
//   border, interior  RMS of the same places near the border, and of the others; mm
//   rmsAll, maxAll, borderAll    as rms, max, border, with the foreign places whose nearest truth is visible
//   covered           share of the visible truth with a place of the mesh nearer than 1 mm; coveredFace and so on: of its
//                     parts with that label
//   foreign           share of the mesh's area that is foreign; tissue: that is foreign and in tissue that is not the
//                     baby's, or within 2 mm of it: wall, placenta, cord. The rest lies in the fluid or inside the baby
//   spurs, spurArea   number and mm² of the connected parts of the mesh that have no truth within 1.5 mm and somewhere
//                     none within 2 mm (findSpurs); tissue that is not the baby's counts too. spurless: 1 if there is
//                     none, else 0. spurX, spurY, spurZ: the middle of the one with the largest area, world mm
//   eyes, nose, mouth, detail    mean angle in degrees between the normals of the truth and of the mesh's nearest place,
//                     over the visible truth at each feature, and over all of them; places that the mesh misses by more
//                     than 2 mm count as 90 degrees. A mesh that is turned inside out as a whole is turned back first.
//   landmarks, pose   mean distance in mm of the five landmarks that the program (fitFace) found, and the angle in degrees by which
//                     the head that it found is turned from the true one (comparePose); landmarksMax: the worst of the
//                     five. confidence: the program's own; misled: 1 if that is 0.5 or more and landmarks above 10 mm
//   cpuSeconds, wallSeconds    of the whole pipeline, from a volume in memory; CPU: all threads
//   triangles, area   of the mesh; mm²
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
struct FaceScore {
  double rms = kUnknown, p95 = kUnknown, max = kUnknown, offset = kUnknown;
  double border = kUnknown, interior = kUnknown;
  double rmsAll = kUnknown, maxAll = kUnknown, borderAll = kUnknown;
  double covered = 0;
  double coveredFace = kUnknown, coveredHead = kUnknown, coveredHand = kUnknown, coveredBody = kUnknown;
  double foreign = kUnknown, tissue = kUnknown, spurs = kUnknown, spurArea = kUnknown, spurless = kUnknown;
  double spurX = kUnknown, spurY = kUnknown, spurZ = kUnknown;
  double eyes = kUnknown, nose = kUnknown, mouth = kUnknown, detail = kUnknown;
  double landmarks = kUnknown, landmarksMax = kUnknown, pose = kUnknown;
  double confidence = kUnknown, misled = kUnknown;
  double cpuSeconds = kUnknown, wallSeconds = kUnknown;
  double triangles = 0, area = 0;
};

// scoreFace: all that can be said of the mesh itself; landmarks, pose and seconds are left unknown.
//   mesh     may be empty: nothing is covered then, and the rest is unknown
//   cost     0.4 s of CPU for 10,000 mm² and 150,000 triangles
//   threads  the result does not depend on their number
FaceScore scoreFace(const Mesh& mesh, const FaceTruth& truth);

}  // namespace sonoskin::accuracy
