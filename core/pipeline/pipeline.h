#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/classification/iso_value.h"
#include "core/face/face_fit.h"
#include "core/mesh/mesh.h"
#include "core/pipeline/kept_parts.h"
#include "core/pipeline/parameters.h"
#include "core/pipeline/stage_keys.h"
#include "core/surface/edge_placement.h"
#include "core/surface/surface_points.h"
#include "core/volume/scan.h"

namespace sonoskin {

// StageReport: what one stage of a run cost. `seconds` and `bytes` are 0 where an earlier result was used
// again.
struct StageReport {
  std::string name;
  double seconds = 0;
  std::size_t bytes = 0;  // of the stage's result
};

struct ScanEvidence;  // core/pipeline/scan_evidence.h

// Goal: how far a run goes.
//   surface   to a mesh, for somebody who turns a slider: made from the live classification unless the final one is known
//   mesh      to a mesh made from a classification that is solved to its tolerance
enum class Goal { classified, points, surface, mesh };

// Preview: voxels of twice or four times the size; long voxels grow less.
enum class Preview { half, quarter };

// Results: what a run has made so far; later members are empty until their stage has run.
struct Results {
  double isoValue = 0;      // the iso-value used: given, or found from the volume
  IsoRange isoRange;        // what it was found from, and its range from place to place
  double visibleLevel = 0;  // the grey value that views of the volume take for skin
  StageKeys keys;           // of all that the parameters lead to, without short cuts
  bool isFinal = false;     // the mesh is what Goal::mesh leads to
  std::shared_ptr<const Volume<float>> classified;      // u in [0, 1]
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

// Pipeline: volume -> low-pass -> classification -> thinning -> points -> fit -> mesh, remembering earlier
// results so that a change of a parameter repeats only what depends on it. One thread at a time.
class Pipeline {
 public:
  Pipeline();
  ~Pipeline();
  // run: brings everything up to `goal`.
  //   goal         up to `points` sliders are answered: classified to within 0.02 of the solution; for a mesh to
  //                classification.tolerance
  //   stageBegins  called with a word for people ("classification") as each stage starts
  //   errors       Error: nothing was found, or a parameter is out of range; Cancelled. Memory is as before.
  using StageBegins = std::function<void(const std::string& name)>;
  Results run(const Scan& scan, const Parameters& parameters, Goal goal, const Progress& progress = {},
              const StageBegins& stageBegins = {});
  // preview: classification alone, on larger voxels; the geometry of the result tells.
  Results preview(const Scan& scan, const Parameters& parameters, Preview level,
                  const Progress& progress = {});

 private:
  struct Stages;
  std::unique_ptr<Stages> stages_;
};

}  // namespace sonoskin
