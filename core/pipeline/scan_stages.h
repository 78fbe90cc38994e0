#pragma once

#include "core/pipeline/found_points.h"
#include "core/pipeline/live_solver.h"
#include "core/pipeline/scan_evidence.h"
#include "core/pipeline/stage_run.h"

namespace sonoskin {

// The stages from the scan to what is found in its voxels. Each takes what it is made from and gives a value with its
// key; all are remembered.
//   errors  Cancelled, and what is said at each

// enhanceScan: the volume with less speckle; the scan's own where none is to go.
Keyed<Volume<float>> enhanceScan(const StageContext& context);

// halveVolume: the same on voxels of twice the size, for previews.
Keyed<Volume<float>> halveVolume(const StageContext& context, const Keyed<Volume<float>>& volume);

// prepareVolume: what classification needs.
//   errors  Error: see prepare
ClassifierInput prepareVolume(const StageContext& context, const Keyed<Volume<float>>& volume);

// isoValueOf: the iso-value that is given, or the one of the whole volume that was found.
double isoValueOf(const ClassificationOptions& options, const GreyLevels& levels);

// classifyVolume: u.
//   live    takes a short cut where what is solved to the tolerance is not known yet: another result, with a key of its
//           own; null: no short cut
//   errors  Error: see classify
Keyed<Volume<float>> classifyVolume(const StageContext& context, const ClassifierInput& input,
                                    LiveSolver* live);

// findPoints: on the skin; none where nothing is found.
//   errors  Error: see regionOf
Keyed<FoundPoints> findPoints(const StageContext& context, const ClassifierInput& input,
                              const Keyed<Volume<float>>& classified);

// weighScan: what speaks for skin in fluid.
Keyed<ScanEvidence> weighScan(const StageContext& context, const ClassifierInput& input,
                              const Keyed<FoundPoints>& found);

// findFace: where the face is; nothing, and a zero key, where none is to be looked for.
//   hurried  whoever turns a slider does not wait for a face; one that is known already is used
Keyed<FaceFit> findFace(const StageContext& context, const ClassifierInput& input,
                        const Keyed<FoundPoints>& found, bool hurried);

}  // namespace sonoskin
