#pragma once

#include "core/base/progress.h"
#include "core/classification/classification_options.h"
#include "core/classification/iso_value.h"
#include "core/volume/volume.h"

namespace sonoskin {

// DataTerm: the part of the system that stands on the diagonal, one value per voxel.
//   diagonal  c = alpha a + gamma h
//   right     b = gamma h uind
//   a = min((w (v - viso)^2 + (1 - w)(v~ - viso)^2 + nf^2) / (|grad|^2 + eps), farthest^2)
//       a squared distance to the iso-surface, in voxels; beyond `farthest` all are equally far, which keeps
//       the system well conditioned
//   h = delta + (1 - delta) min(1, |grad| / gref)
//   grad: of v~ or of v, as gradientSource says
struct DataTerm {
  LargeArray<float> diagonal, right;
};

// DataSource: what the data term is made from.
//   raw, lowPassed  v and v~, the same geometry
//   levels          where options.isoValue is 0: v_iso from place to place, by isoShare
struct DataSource {
  const Volume<float>& raw;
  const Volume<float>& lowPassed;
  const ClassificationOptions& options;
  GreyLevels levels{};
};

// dataTerm: see above.
//   errors   Cancelled
DataTerm dataTerm(const DataSource& source, const Progress& progress = {});

// dataTermRow: the same for the row of voxels (., j, k).
//   diagonal, right  room for dims.x values
void dataTermRow(const DataSource& source, int j, int k, float* diagonal, float* right);

// absoluteBeta: the beta of the functional that smooths over the options' tangential length at a typical
// edge: beta l^2 gamma h_ref, h_ref = h at |grad| = 0.06.
double absoluteBeta(const ClassificationOptions& options);

// couplingLength: how far what happens at one voxel reaches at most: within so many smallest spacings it fades by e.
//   method  sqrt(beta |g|^2 / c), the largest of any gradient: where edges are weak, c holds u down, and where they are
//           strong, h does
double couplingLength(const ClassificationOptions& options);

}  // namespace sonoskin
