#pragma once

#include "core/base/progress.h"
#include "core/classification/iso_value.h"
#include "core/surface/edge_placement.h"
#include "core/surface/surface_points.h"
#include "core/volume/field_of_view.h"
#include "core/volume/scan.h"

namespace sonoskin {

// ScanEvidence: what speaks for skin in fluid, seen by ultrasound. Whatever could not be measured is as in a good scan.
//   hasEdges  whether any grey differs from its neighbours'
//   noise     mean difference of a voxel from its six neighbours' mean, grey
//   dark      of the view: darker than half-way from the fluid to the edges
//   sideways  of the steepest edges, by gradient: those at more than 60 degrees to the beam; half of all where edges
//             face every way alike
//   clear     of the surface: with fluid close before it along the beam
//   largest   of the surface: in its largest piece
//   rise      grey across the surface, from before to behind; `width`: mm of it from 20 to 80 %
struct ScanEvidence {
  bool hasEdges = true;
  double noise = 0, dark = 1, sideways = 0, clear = 1, largest = 1, rise = 1, width = 0;
};

// EvidenceInput: what evidence is drawn from.
//   recorded, lowPassed  of the same geometry, grey in [0, 1]
//   points               the surface that was found; may be empty
//   edge                 across it; all zero where it was not measured
struct EvidenceInput {
  const Volume<float>&recorded, &lowPassed;
  const FieldOfView& view;
  const Beam& beam;
  const GreyLevels& levels;
  const SurfacePoints& points;
  const EdgeProfile& edge;
};

// weighEvidence: looks at 230,000 voxels within the view, evenly spread, and at 4,000 points.
//   cost     40 ms of one core
//   errors   Cancelled
//   threads  the result does not depend on their number
ScanEvidence weighEvidence(const EvidenceInput& input, const Progress& progress = {});

}  // namespace sonoskin
