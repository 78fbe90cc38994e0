#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/pipeline/parameters.h"
#include "core/pipeline/results.h"
#include "core/volume/scan.h"

namespace sonoskin {

// Goal: how far a run goes.
//   levels    to the grey levels alone, for views of the volume itself
//   surface   to a mesh, for somebody who turns a slider: made from the live classification unless the final one is known
//   mesh      to a mesh made from a classification that is solved to its tolerance
enum class Goal { levels, classified, points, surface, mesh };

// Preview: voxels of twice or four times the size; long voxels grow less.
enum class Preview { half, quarter };

// kResultBytes: what a pipeline remembers, at most: a mesh and what moving sliders show beside it, of a scan of 30 million
// voxels; of smaller ones some of what was before, too.
inline constexpr std::size_t kResultBytes = 280u << 20;

// Pipeline: volume -> low-pass -> classification -> thinning -> points -> fit -> mesh, remembering earlier
// results so that a change of a parameter repeats only what depends on it. One thread at a time.
class Pipeline {
 public:
  //   budget  bytes of the results that are remembered (ResultMemory); what one run needs is, whatever it takes
  explicit Pipeline(std::size_t budget = kResultBytes);
  ~Pipeline();
  // run: brings everything up to `goal`.
  //   goal         up to `points` sliders are answered: classified to within 0.02 of the solution; for a mesh to
  //                classification.tolerance
  //   stageBegins  called with a word for people ("classification") as each stage starts
  //   errors       Error: nothing was found, or a parameter is out of range; Cancelled. What was made until then is
  //                remembered.
  using StageBegins = std::function<void(const std::string& name)>;
  Results run(const Scan& scan, const Parameters& parameters, Goal goal, const Progress& progress = {},
              const StageBegins& stageBegins = {});
  // preview: classification alone, on larger voxels; the geometry of the result tells.
  //   errors  Error: a parameter is out of range; Cancelled
  Results preview(const Scan& scan, const Parameters& parameters, Preview level,
                  const Progress& progress = {});
  // slices: classification alone, of the slices that are looked at, for somebody who turns a slider of a large volume.
  //   voxel   that all three go through
  //   each    told of the result with one, two and all three of them, the fastest first
  //   output  without slices where more than the classification itself has changed since the last run, which has to be
  //           known for all of the volume; and for the thesis' formulations
  //   errors  Error: a parameter is out of range; Cancelled
  Results slices(const Scan& scan, const Parameters& parameters, const glm::ivec3& voxel,
                 const Progress& progress = {}, const std::function<void(const Results&)>& each = {});
  // forget: gives the memory of all results back, as for another document.
  void forget();

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace sonoskin
