#include "core/pipeline/pipeline.h"

#include <algorithm>
#include <array>
#include <functional>

#include "core/classification/coarser_options.h"
#include "core/pipeline/check_ranges.h"
#include "core/pipeline/mesh_stages.h"
#include "core/pipeline/result_memory.h"
#include "core/pipeline/scan_doubts.h"
#include "core/pipeline/scan_stages.h"
#include "core/pipeline/slice_solver.h"

namespace sonoskin {
namespace {

constexpr double kPreviewTolerance = 1e-2;
constexpr double kVisibleShare = 0.6;  // of the way from the fluid to the edges: clear of the fluid's noise

// What the iso-value was found from.
IsoRange isoRangeUsed(const ClassificationOptions& options, const GreyLevels& levels) {
  IsoRange range = isoRangeOf(levels, options.isoShare);
  if (options.isoValue > 0) range.least = range.most = options.isoValue, range.automatic = false;
  // The thesis' formulations know one iso-value for the whole volume.
  else if (options.formulation != Formulation::variational)
    range.least = range.most = double(levels.iso(options.isoShare));
  return range;
}

void noteLevels(const ClassificationOptions& options, const GreyLevels& levels, Results& results) {
  results.isoValue = isoValueOf(options, levels);
  results.isoRange = isoRangeUsed(options, levels);
  results.visibleLevel = double(levels.between(kVisibleShare));
}

}  // namespace

// Memory: what a pipeline keeps from run to run.
struct Pipeline::Memory {
  ResultMemory results;
  LiveSolver solver;
  std::array<LiveSolver, 2> previewSolvers{};  // by Preview
  SliceSolver sliceSolver{};

  // forgetSolvers: gives the systems back that sliders are answered with.
  void forgetSolvers();
};

Pipeline::Pipeline(std::size_t budget) : memory_(new Memory{ResultMemory(budget), {}}) {}
Pipeline::~Pipeline() = default;

void Pipeline::Memory::forgetSolvers() {
  solver.forget();
  for (LiveSolver& preview : previewSolvers) preview.forget();
  sliceSolver.forget();
}

void Pipeline::forget() {
  memory_->results.forget();
  memory_->forgetSolvers();
}

Results Pipeline::run(const Scan& scan, const Parameters& parameters, Goal goal, const Progress& progress,
                      const StageBegins& stageBegins) {
  checkRanges(parameters);
  Results results;
  results.keys = stageKeys(scan.key, scan.erasedKey, parameters);
  const StageShares shares = sharesOf(parameters);
  const bool hurried = goal != Goal::mesh;
  // Who asks for the mesh has turned the sliders for now: their systems, 13 bytes a voxel, make room for the rest.
  if (!hurried) memory_->forgetSolvers();
  memory_->results.beginRun(!hurried);
  const double whole = goal == Goal::levels       ? 1 / shares.prepared.until
                       : goal == Goal::classified ? 1 / shares.classified.until
                                                  : 1;
  StageRun run(memory_->results, progress.part(0, whole), stageBegins, results.stages);
  const StageContext context{scan, parameters, shares, run};

  const ClassifierInput input = prepareVolume(context, enhanceScan(context));
  const Prepared& prepared = *input.prepared.value;
  noteLevels(parameters.classification, prepared.smoothed.levels, results);
  if (goal == Goal::levels) return results;
  const auto classified = classifyVolume(context, input, hurried ? &memory_->solver : nullptr);
  results.classified = classified.value;
  if (goal == Goal::classified) return results;
  const Keyed<FoundPoints> found = findPoints(context, input, classified);
  results.thinned = found.value->thinned;
  results.points = found.value->points;
  results.edge = found.value->edge;
  results.evidence = weighScan(context, input, found).value;
  const Keyed<FaceFit> face = findFace(context, input, found, hurried);
  results.face = face.value;
  results.warnings = doubtsOf(scan, *results.evidence, face.value.get(), parameters.face);
  if (goal == Goal::points) return results;
  const Key mesh = makeMesh(context, {found, face, prepared.beam}, results);
  results.isFinal = mesh == results.keys.mesh;
  return results;
}

Results Pipeline::slices(const Scan& scan, const Parameters& parameters, const glm::ivec3& voxel,
                         const Progress& progress, const std::function<void(const Results&)>& each) {
  checkRanges(parameters);
  Results results;
  results.keys = stageKeys(scan.key, scan.erasedKey, parameters);
  memory_->results.beginRun(false);
  const auto prepared = memory_->results.find<Prepared>(results.keys.prepared);
  const auto volume = parameters.enhancement.method == EnhancementMethod::none
                          ? scan.volume
                          : memory_->results.find<Volume<float>>(results.keys.enhanced);
  const ClassificationOptions& options = parameters.classification;
  if (!prepared || !volume || options.formulation != Formulation::variational) return results;
  noteLevels(options, prepared->smoothed.levels, results);
  const glm::ivec3 dims = volume->geometry.dims;
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::sort(axes, std::greater(), [&](int axis) { return dims[axis]; });  // smallest slice first
  for (const int axis : axes) {
    results.slices[std::size_t(axis)] =
        memory_->sliceSolver.classify({{volume, results.keys.enhanced}, {prepared, results.keys.prepared}},
                                      options, {axis, voxel[axis]}, progress.cancelOnly());
    if (each) each(results);
  }
  progress.update(1);
  return results;
}

// The same stages on larger voxels.
Results Pipeline::preview(const Scan& scan, const Parameters& parameters, Preview level,
                          const Progress& progress) {
  checkRanges(parameters);
  Results results;
  results.keys = stageKeys(scan.key, scan.erasedKey, parameters);
  const StageShares shares = sharesOf(parameters);
  memory_->results.beginRun(false);
  StageRun run(memory_->results, progress.part(0, 1 / shares.classified.until), {}, results.stages);
  const StageContext full{scan, parameters, shares, run};
  Keyed<Volume<float>> volume = halveVolume(full, enhanceScan(full));
  if (level == Preview::quarter) volume = halveVolume(full, volume);

  Scan coarser = scan;
  coarser.volume = volume.value;
  Parameters adapted = parameters;
  ClassificationOptions& classification = adapted.classification;
  classification = coarserOptions(classification,
                                  coarser.volume->geometry.minSpacing() / scan.volume->geometry.minSpacing());
  classification.tolerance = kPreviewTolerance;
  const StageContext context{coarser, adapted, shares, run};
  const ClassifierInput input = prepareVolume(context, volume);
  // The levels of the volume itself, where they are known: the full answer will use them.
  const auto known = memory_->results.find<Prepared>(results.keys.prepared);
  const GreyLevels& levels = (known ? known : input.prepared.value)->smoothed.levels;
  noteLevels(classification, levels, results);
  if (classification.formulation != Formulation::variational) classification.isoValue = results.isoValue;
  LiveSolver& solver = memory_->previewSolvers[std::size_t(level)];
  results.classified = classifyVolume(context, input, &solver).value;
  return results;
}

}  // namespace sonoskin
