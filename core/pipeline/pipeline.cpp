#include "core/pipeline/pipeline.h"

#include "core/base/error.h"
#include "core/base/timer.h"
#include "core/classification/coarser_options.h"
#include "core/classification/live_classifier.h"
#include "core/enhancement/diffusion.h"
#include "core/mesh/components.h"
#include "core/mesh/print/print_solid.h"
#include "core/mesh/repair/clean.h"
#include "core/pipeline/check_ranges.h"
#include "core/pipeline/choose_piece.h"
#include "core/pipeline/face_use.h"
#include "core/pipeline/kept_parts.h"
#include "core/pipeline/prepared.h"
#include "core/pipeline/scan_doubts.h"
#include "core/pipeline/stage.h"
#include "core/pipeline/stage_keys.h"
#include "core/rbf/surface/fitted_surface.h"
#include "core/rbf/surface/iso_surface.h"
#include "core/surface/find_surface.h"
#include "core/surface/first_hit.h"
#include "core/volume/resample.h"

namespace sonoskin {
namespace {

constexpr double kPreviewTolerance = 1e-2;
constexpr double kVisibleShare = 0.6;  // of the way from the fluid to the edges: clear of the fluid's noise

// The iso-value that is given, or the one of the whole volume that was found.
double isoValueOf(const ClassificationOptions& options, const GreyLevels& levels) {
  return options.isoValue > 0 ? options.isoValue : double(levels.iso(options.isoShare));
}

// What it was found from.
IsoRange isoRangeOf(const ClassificationOptions& options, const GreyLevels& levels) {
  IsoRange range = sonoskin::isoRangeOf(levels, options.isoShare);
  if (options.isoValue > 0) range.least = range.most = options.isoValue, range.automatic = false;
  // The thesis' formulations know one iso-value for the whole volume.
  else if (options.formulation != Formulation::variational)
    range.least = range.most = double(levels.iso(options.isoShare));
  return range;
}

struct Points {
  std::shared_ptr<const Volume<std::uint8_t>> thinned;
  std::shared_ptr<const SurfacePoints> points;
  EdgeProfile edge;
};

std::size_t bytesOf(const Prepared& p) { return p.smoothed.lowPassed.data.size() * (sizeof(float) + 3); }
std::size_t bytesOf(const Volume<float>& v) { return v.data.size() * sizeof(float); }
std::size_t bytesOf(const Points& p) { return p.thinned->data.size() + p.points->size() * 28; }
std::size_t bytesOf(const FaceFit&) { return sizeof(FaceFit); }
std::size_t bytesOf(const ScanEvidence&) { return sizeof(ScanEvidence); }
std::size_t bytesOf(const FittedSurface& f) { return f.bytes; }
std::size_t bytesOf(const Mesh& m) { return m.positions.size() * 24 + m.triangles.size() * sizeof(Triangle); }
std::size_t bytesOf(const KeptParts& k) { return bytesOf(k.mesh) + k.verdicts.size() * sizeof(PartVerdict); }
std::size_t bytesOf(const PartedSurface& s) {
  return bytesOf(s.mesh) + 2 * s.parts.ofTriangle.size() * sizeof(std::uint32_t) +
         s.parts.graph.size() * 10 * sizeof(float);
}
std::size_t bytesOf(const std::vector<Mesh>& pieces) {
  std::size_t bytes = 0;
  for (const Mesh& m : pieces) bytes += bytesOf(m);
  return bytes;
}

Points pointsOf(const Scan& scan, const Volume<float>& classified, const Prepared& prepared, double iso,
                const Parameters& parameters, const Progress& progress) {
  const SurfaceInput input{*scan.volume,
                           classified,
                           prepared.smoothed.lowPassed,
                           {prepared.beam, prepared.view, regionOf(scan, parameters.region)},
                           iso};
  FoundSurface found = findSurface(input, parameters.surface, progress);
  return {std::make_shared<const Volume<std::uint8_t>>(thinnedVolume(found.voxels, classified.geometry)),
          std::make_shared<const SurfacePoints>(std::move(found.points)), found.edge};
}

glm::dvec3 centreOf(const Geometry& g) { return g.toWorld(0.5 * glm::dvec3(g.dims - 1)); }

// LiveMemory: the classifier of one volume, as long as what was prepared from it stays the same.
struct LiveMemory {
  std::unique_ptr<LiveClassifier> classifier;
  Key key;

  std::shared_ptr<const Volume<float>> classify(const Key& preparedKey,
                                                const std::shared_ptr<const Volume<float>>& volume,
                                                const std::shared_ptr<const Prepared>& prepared,
                                                const ClassificationOptions& options,
                                                const Progress& progress) {
    if (options.formulation != Formulation::variational)
      return std::make_shared<const Volume<float>>(
          sonoskin::classify(*volume, prepared->smoothed, options, progress));
    if (!classifier || key != preparedKey) {
      classifier.reset();  // its memory, before the next one takes as much
      classifier = std::make_unique<LiveClassifier>(
          volume, std::shared_ptr<const Smoothed>(prepared, &prepared->smoothed));
      key = preparedKey;
    }
    return classifier->classify(options, progress);
  }
};

// CoarseLevel: what previews on larger voxels keep.
struct CoarseLevel {
  Stage<Volume<float>> volume{1};
  Stage<Prepared> prepared{1};
  LiveMemory live;
};

// One run: hands each stage its slice of the progress and notes what it cost.
class Run {
 public:
  Run(const Progress& progress, Pipeline::StageBegins stageBegins, Results& results)
      : progress_(progress), stageBegins_(std::move(stageBegins)), results_(results) {}

  // stage: the remembered result for `key`, or a new one; the progress then stands at `until`.
  template <class T, class Compute>
  std::shared_ptr<const T> stage(const char* name, double until, Stage<T>& memory, const Key& key,
                                 const Compute& compute) {
    const Progress part = progress_.part(at_, until);
    at_ = until;
    progress_.throwIfCancelled();
    if (auto known = memory.find(key)) {
      results_.stages.push_back({name, 0, 0});
      return known;
    }
    if (stageBegins_) stageBegins_(name);
    const Timer timer;
    auto made = memory.remember(key, compute(part));
    results_.stages.push_back({name, timer.seconds(), bytesOf(*made)});
    return made;
  }

 private:
  Progress progress_;
  Pipeline::StageBegins stageBegins_;
  Results& results_;
  double at_ = 0;
};

// Way: what the steps of one run share.
//   keys  of what it makes, with the short cuts that it takes
struct Way {
  const Scan& scan;
  const Parameters& parameters;
  Run& run;
  Results& results;
  Precision precision{};
  StageKeys keys = stageKeys(scan.key, scan.erasedKey, parameters);

  void cutShort(const Precision& shorter) {
    precision = shorter;
    keys = stageKeys(scan.key, scan.erasedKey, parameters, precision);
  }
};

// Start: what classification begins from: the scan's own volume or the enhanced one, and what is known of it.
struct Start {
  std::shared_ptr<const Volume<float>> volume;
  std::shared_ptr<const Prepared> prepared;
};

}  // namespace

// Stages: what is remembered, and the steps that fill it.
struct Pipeline::Stages {
  Stage<Volume<float>> enhanced{1};
  Stage<Prepared> prepared{1};
  Stage<Volume<float>> classified{3};
  Stage<Points> points{3};
  Stage<ScanEvidence> evidence{3};
  Stage<FaceFit> face{3};
  Stage<FittedSurface> fitted{3};
  Stage<std::vector<Mesh>> pieces{3};
  Stage<PartedSurface> parts{2};
  Stage<KeptParts> piece{3};
  Stage<Mesh> mesh{3}, print{1};
  LiveMemory live;
  Stage<Volume<float>> liveClassified{3};
  CoarseLevel half, quarter;

  std::shared_ptr<const Volume<float>> enhance(const Way& way);
  Start start(const Way& way);
  void classify(Way& way, const Start& start, Goal goal);
  void findPoints(const Way& way, const Start& start);
  void weigh(const Way& way, const Prepared& prepared);
  void findFace(Way& way, const Prepared& prepared, Goal goal);
  void findPieces(const Way& way, double until);
  void choose(const Way& way, const Prepared& prepared, double until);
  void finishMesh(const Way& way, double cleanUntil);
};

std::shared_ptr<const Volume<float>> Pipeline::Stages::enhance(const Way& way) {
  const EnhancementOptions& options = way.parameters.enhancement;
  if (options.method == EnhancementMethod::none) return way.scan.volume;
  return way.run.stage("enhancement", 0.1, enhanced, way.keys.enhanced,
                       [&](const Progress& p) { return diffuse(*way.scan.volume, options, p); });
}

Start Pipeline::Stages::start(const Way& way) {
  Start start;
  start.volume = enhance(way);
  start.prepared = way.run.stage("low-pass", 0.15, prepared, way.keys.prepared, [&](const Progress& p) {
    return prepare(way.scan, *start.volume, way.parameters, p);
  });
  return start;
}

// Sliders are answered fast; what a mesh is made from is solved to the tolerance.
void Pipeline::Stages::classify(Way& way, const Start& start, Goal goal) {
  ClassificationOptions options = way.parameters.classification;
  const GreyLevels& levels = start.prepared->smoothed.levels;
  way.results.isoValue = isoValueOf(options, levels);
  way.results.isoRange = isoRangeOf(options, levels);
  way.results.visibleLevel = double(levels.between(kVisibleShare));
  if (options.formulation != Formulation::variational) options.isoValue = way.results.isoValue;
  if (goal != Goal::mesh && !classified.find(way.keys.classified)) way.cutShort({false, true});
  const bool solved = way.precision.solved;
  Stage<Volume<float>>& memory = solved ? classified : liveClassified;
  way.results.classified =
      way.run.stage("classification", 0.5, memory, way.keys.classified, [&](const Progress& p) {
        if (!solved) return live.classify(way.keys.prepared, start.volume, start.prepared, options, p);
        return std::make_shared<const Volume<float>>(
            sonoskin::classify(*start.volume, start.prepared->smoothed, options, p));
      });
}

void Pipeline::Stages::findPoints(const Way& way, const Start& start) {
  const auto found = way.run.stage("points", 0.6, points, way.keys.points, [&](const Progress& p) {
    return pointsOf(way.scan, *way.results.classified, *start.prepared, way.results.isoValue, way.parameters,
                    p);
  });
  way.results.thinned = found->thinned;
  way.results.points = found->points;
  way.results.edge = found->edge;
}

void Pipeline::Stages::weigh(const Way& way, const Prepared& from) {
  const Key key = Hasher("evidence 1").add(way.keys.points).key();
  way.results.evidence = way.run.stage("evidence", 0.61, evidence, key, [&](const Progress& p) {
    return weighEvidence({*way.scan.volume, from.smoothed.lowPassed, from.view, from.beam,
                          from.smoothed.levels, *way.results.points, way.results.edge},
                         p);
  });
}

// Whoever turns a slider does not wait for a face; one that is known already is used.
void Pipeline::Stages::findFace(Way& way, const Prepared& from, Goal goal) {
  const FaceOptions& options = way.parameters.face;
  if (!options.find) return;
  if (goal != Goal::mesh && !face.find(way.keys.face)) return way.cutShort({way.precision.solved, false});
  way.results.face = way.run.stage("face", 0.65, face, way.keys.face, [&](const Progress& p) {
    const Volume<float>& lowPassed = from.smoothed.lowPassed;
    const float dark = findFluidLevels(lowPassed, from.view, way.results.isoValue).dark;
    return fitFace({*way.results.points, &lowPassed, dark, from.beam}, options, p);
  });
}

// The fit, and all pieces of its surface.
void Pipeline::Stages::findPieces(const Way& way, double until) {
  require(way.results.points->size() > 0 || way.results.warnings.empty(), "no surface was found: {}",
          way.results.warnings.empty() ? "" : way.results.warnings.front());
  require(way.results.points->size() > 0,
          "no surface was found: move classification.isoValue (now {:.2f}) toward the grey of the skin's "
          "edge, or lower surface.minClusterArea",
          way.results.isoValue);
  const auto fit = way.run.stage("fit", 0.8, fitted, way.keys.fit, [&](const Progress& p) {
    return fitSurface(*way.results.points, way.parameters.reconstruction, way.parameters.global, p);
  });
  way.results.centres = fit->centres;
  way.results.globalError = fit->report.globalError;
  way.results.globalErrorWithWeights = fit->report.globalErrorWithWeights;
  way.results.pieces = way.run.stage("surface", until, pieces, way.keys.pieces, [&](const Progress& p) {
    const MeshOptions& options = way.parameters.mesh;
    const ImplicitFunction function = fit->function(meshCell(way.results.points->positions, options));
    return splitPieces(extractIsoSurface(function, *way.results.points, options, p));
  });
}

// The parts or pieces that were asked for.
void Pipeline::Stages::choose(const Way& way, const Prepared& from, double until) {
  const MeshOptions& options = way.parameters.mesh;
  const glm::dvec3 middle = centreOf(way.scan.volume->geometry);
  const bool inParts = cutsParts(options);
  if (inParts)
    way.results.parts = way.run.stage("parts", 0.99 * until, parts, way.keys.parts, [&](const Progress& p) {
      return partSurface(*way.results.pieces, options, p);
    });
  const auto chosen = way.run.stage("piece", until, piece, way.keys.kept, [&](const Progress& p) {
    if (!inParts) return KeptParts{choosePiece(*way.results.pieces, options, from.beam, middle), {}};
    const PartView view{from.beam, middle, options.companions,
                        siteOf(way.results.face.get(), way.parameters.face)};
    return keepAsAsked(*way.results.parts, options, view, p);
  });
  way.results.mesh = std::shared_ptr<const Mesh>(chosen, &chosen->mesh);
  if (inParts)
    way.results.verdicts = std::shared_ptr<const std::vector<PartVerdict>>(chosen, &chosen->verdicts);
}

// What was chosen, cleaned, and as a solid.
void Pipeline::Stages::finishMesh(const Way& way, double cleanUntil) {
  const MeshOptions& options = way.parameters.mesh;
  if (needsCleaning(options)) {
    const auto chosen = way.results.mesh;
    way.results.mesh = way.run.stage("clean", cleanUntil, mesh, way.keys.mesh,
                                     [&](const Progress& p) { return cleanMesh(*chosen, options, p); });
  }
  if (way.parameters.print.form != PrintForm::none)
    way.results.print = way.run.stage("print", 1, print, way.keys.print, [&](const Progress& p) {
      return makePrintSolid(*way.results.mesh, way.parameters.print, p);
    });
}

Pipeline::Pipeline() : stages_(std::make_unique<Stages>()) {}
Pipeline::~Pipeline() = default;

Results Pipeline::run(const Scan& scan, const Parameters& parameters, Goal goal, const Progress& progress,
                      const StageBegins& stageBegins) {
  checkRanges(parameters);
  Results results;
  Run run(goal == Goal::classified ? progress.part(0, 2) : progress, stageBegins, results);
  Way way{scan, parameters, run, results};
  results.keys = way.keys;
  const Start start = stages_->start(way);
  stages_->classify(way, start, goal);
  if (goal == Goal::classified) return results;
  stages_->findPoints(way, start);
  stages_->weigh(way, *start.prepared);
  stages_->findFace(way, *start.prepared, goal);
  results.warnings = doubtsOf(scan, *results.evidence, results.face.get(), parameters.face);
  if (goal == Goal::points) return results;
  results.isFinal = way.precision.solved && (way.precision.face || !cutsParts(parameters.mesh));
  // Shares of the progress: a solid takes most of the time where one is made.
  const double cleaned = parameters.print.form == PrintForm::none ? 1 : 0.85;
  const double chosen = needsCleaning(parameters.mesh) ? 0.9 * cleaned : cleaned;
  stages_->findPieces(way, 0.95 * chosen);
  stages_->choose(way, *start.prepared, chosen);
  stages_->finishMesh(way, cleaned);
  return results;
}

Results Pipeline::preview(const Scan& scan, const Parameters& parameters, Preview level,
                          const Progress& progress) {
  checkRanges(parameters);
  Results results;
  Run run(progress, {}, results);
  const Way way{scan, parameters, run, results};
  results.keys = way.keys;
  const auto input = stages_->enhance(way);
  const auto halve = [&](Stage<Volume<float>>& memory, const Volume<float>& volume, double until) {
    return run.stage("coarser voxels", until, memory, way.keys.enhanced,
                     [&](const Progress& p) { return halveResolution(volume, p); });
  };
  CoarseLevel& coarse = level == Preview::half ? stages_->half : stages_->quarter;
  Scan coarser = scan;
  coarser.volume = halve(stages_->half.volume, *input, 0.2);
  if (level == Preview::quarter) coarser.volume = halve(stages_->quarter.volume, *coarser.volume, 0.3);
  Parameters adapted = parameters;
  adapted.classification = coarserOptions(
      parameters.classification, coarser.volume->geometry.minSpacing() / scan.volume->geometry.minSpacing());
  adapted.classification.tolerance = kPreviewTolerance;
  const Key& key = way.keys.prepared;
  const auto prepared = run.stage("low-pass", 0.5, coarse.prepared, key, [&](const Progress& p) {
    return prepare(coarser, *coarser.volume, adapted, p);
  });
  // The levels of the volume itself, where they are known: the full answer will use them.
  const auto full = stages_->prepared.find(key);
  const GreyLevels levels = full ? full->smoothed.levels : prepared->smoothed.levels;
  ClassificationOptions& classification = adapted.classification;
  results.isoValue = isoValueOf(classification, levels);
  results.isoRange = isoRangeOf(classification, levels);
  results.visibleLevel = double(levels.between(kVisibleShare));
  if (classification.formulation != Formulation::variational) classification.isoValue = results.isoValue;
  results.classified =
      coarse.live.classify(key, coarser.volume, prepared, classification, progress.part(0.5, 1));
  return results;
}

}  // namespace sonoskin
