#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/classification/iso_value.h"
#include "core/face/face_fit.h"
#include "core/mesh/mesh.h"
#include "core/pipeline/kept_parts.h"
#include "core/pipeline/stage_keys.h"
#include "core/surface/edge_placement.h"
#include "core/surface/surface_points.h"

namespace sonoskin {

// StageReport: what one stage of a run cost. `seconds` and `bytes` are 0 where an earlier result was used
// again.
struct StageReport {
  std::string name;
  double seconds = 0;
  std::size_t bytes = 0;  // of the stage's result
};

struct ScanEvidence;  // core/pipeline/scan_evidence.h

// Results: what a run has made so far; later members are empty until their stage has run.
struct Results {
  double isoValue = 0;      // the iso-value used: given, or found from the volume
  IsoRange isoRange;        // what it was found from, and its range from place to place
  double visibleLevel = 0;  // the grey value that views of the volume take for skin
  StageKeys keys;           // of all that the parameters lead to, without short cuts
  bool isFinal = false;     // the mesh is what Goal::mesh leads to
  std::shared_ptr<const Volume<float>> classified;  // u in [0, 1]
  // Of u, the slices across i, j, k that are looked at, one voxel thick: where they were made first; see Pipeline::slices.
  std::array<std::shared_ptr<const Volume<float>>, 3> slices{};
  std::shared_ptr<const Volume<std::uint8_t>> thinned;  // u as 1..255 on surface voxels, 0 elsewhere
  std::shared_ptr<const SurfacePoints> points;
  EdgeProfile edge;                                 // across the surface, where the points were moved onto it
  std::shared_ptr<const FaceFit> face;              // where the face is; for Goal::mesh, if face.find
  std::size_t centres = 0;                          // of the fitted function
  double globalError = 0;                           // of the fit, as a share of the points' box [thesis 3.22]
  std::optional<double> globalErrorWithWeights;     // the same after the weights λ, if they were fitted
  std::shared_ptr<const std::vector<Mesh>> pieces;  // all pieces of the surface, largest area first
  std::shared_ptr<const Mesh> mesh;                 // the chosen parts or pieces, cleaned as asked
  std::shared_ptr<const Mesh> print;                // a solid of it to print; empty if print.form is none
  std::vector<StageReport> stages;
  std::shared_ptr<const PartedSurface>
      parts{};  // the whole surface in parts; empty where whole pieces are chosen
  std::shared_ptr<const std::vector<PartVerdict>> verdicts{};  // of the parts: which are in the mesh, and why
  std::shared_ptr<const ScanEvidence> evidence{};              // of what was recorded; from Goal::points on
  std::vector<std::string> warnings{};  // a sentence each: why the surface may not be skin, or not in mm
};

}  // namespace sonoskin
