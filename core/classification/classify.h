#pragma once

#include "core/base/progress.h"
#include "core/classification/classification_options.h"
#include "core/classification/smoothed.h"
#include "core/volume/volume.h"

namespace sonoskin {

// classify: the volume u that is near 1 on surfaces and near 0 elsewhere.
//   solves   minimise 1/2 sum alpha a u^2 + beta |grad u x g|^2 + gamma h (u - uind)^2, that is
//            (alpha a + gamma h) u - beta div(D grad u) = gamma h uind
//            [Fattal, Lischinski 2001, with the tangential term of theory/classification.md, 2.3; a and h: data_term.h]
//            with the formulations of the thesis its equation 3.7 instead (thesis_system.h), which needs no
//            `smoothed`
//   options  isoValue 0: from place to place, as `smoothed.levels` and isoShare say; the thesis' formulations need one
//            above 0
//   output   u clamped to [0, uind]
//   errors   Error: the skew system cannot be solved by sweeps; Cancelled
Volume<float> classify(const Volume<float>& volume, const Smoothed& smoothed,
                       const ClassificationOptions& options, const Progress& progress = {});

// clampToTarget: u clamped to [0, uind]. The operator is no M-matrix: a solution overshoots by up to 2 %.
void clampToTarget(Volume<float>& u, const ClassificationOptions& options);

}  // namespace sonoskin
