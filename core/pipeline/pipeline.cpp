#include "core/pipeline/pipeline.h"

#include "core/base/error.h"
#include "core/base/timer.h"
#include "core/classification/classify.h"
#include "core/classification/coarser_options.h"
#include "core/classification/iso_value.h"
#include "core/classification/live_classifier.h"
#include "core/enhancement/diffusion.h"
#include "core/mesh/clean.h"
#include "core/mesh/components.h"
#include "core/mesh/print_solid.h"
#include "core/pipeline/check_ranges.h"
#include "core/pipeline/parameter_key.h"
#include "core/pipeline/stage.h"
#include "core/rbf/fitted_surface.h"
#include "core/rbf/iso_surface.h"
#include "core/surface/find_surface.h"
#include "core/volume/resample.h"

namespace sonoskin {
namespace {

constexpr double kPreviewTolerance = 1e-2;

// Everything that classification needs of the volume itself.
struct Prepared {
  Smoothed smoothed;
  FieldOfView view;
  Beam beam;
  GreyLevels levels;
};

struct Points {
  std::shared_ptr<const Volume<std::uint8_t>> thinned;
  std::shared_ptr<const SurfacePoints> points;
  double echoOffset = 0;
};

std::size_t bytesOf(const Prepared& p) { return p.smoothed.lowPassed.data.size() * (sizeof(float) + 3); }
std::size_t bytesOf(const Volume<float>& v) { return v.data.size() * sizeof(float); }
std::size_t bytesOf(const Points& p) { return p.thinned->data.size() + p.points->size() * 28; }
std::size_t bytesOf(const FittedSurface& f) { return f.bytes; }
std::size_t bytesOf(const Mesh& m) { return m.positions.size() * 24 + m.triangles.size() * sizeof(Triangle); }
std::size_t bytesOf(const std::vector<Mesh>& pieces) {
  std::size_t bytes = 0;
  for (const Mesh& m : pieces) bytes += bytesOf(m);
  return bytes;
}

// Input: the volume that classification begins from: the scan's own, or the enhanced one.
struct Input {
  std::shared_ptr<const Volume<float>> volume;
  Key key;
};

// What lies outside the recorded region is told by the scan's own zeros, which enhancement may blur.
Prepared prepare(const Scan& scan, const Volume<float>& input, const Parameters& parameters,
                 const Progress& progress) {
  Prepared result;
  result.smoothed = smooth(input, parameters.classification, progress.part(0, 0.7));
  const Beam beam = beamOf(scan, parameters.scan);
  result.view = findFieldOfView(scan, beam, progress.part(0.7, 1));
  result.beam = beamWithin(result.view, beam, scan.volume->geometry, parameters.scan);
  result.levels = proposeLevels(result.smoothed.lowPassed, result.view, result.beam);
  return result;
}

Points findPoints(const Scan& scan, const Volume<float>& classified, const Prepared& prepared, double iso,
                  const Parameters& parameters, const Progress& progress) {
  const SurfaceInput input{*scan.volume,
                           classified,
                           prepared.smoothed.lowPassed,
                           {prepared.beam, prepared.view, regionOf(scan, parameters.region)},
                           iso};
  FoundSurface found = findSurface(input, parameters.surface, progress);
  return {std::make_shared<const Volume<std::uint8_t>>(thinnedVolume(found.voxels, classified.geometry)),
          std::make_shared<const SurfacePoints>(std::move(found.points)), found.echoOffset};
}

glm::dvec3 centreOf(const Geometry& g) { return g.toWorld(0.5 * glm::dvec3(g.dims - 1)); }

// The pieces that fill at least `share` of the view that the best one fills: a face and, say, the shoulders beyond
// a shadow.
Mesh piecesInView(const std::vector<Mesh>& pieces, const std::vector<double>& shares, double share) {
  std::vector<Mesh> chosen;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    if (shares[p] >= share) chosen.push_back(pieces[p]);
  return joinPieces(chosen);
}

// The piece of the surface that the options ask for.
Mesh choosePiece(const std::vector<Mesh>& pieces, const MeshOptions& options, const Beam& beam,
                 const glm::dvec3& middle) {
  require(!pieces.empty(), "the surface is empty: lower mesh.support or raise mesh.maxGap");
  switch (options.piece) {
    case PieceChoice::probe:
      return piecesInView(pieces, viewShares(pieces, beam, middle), options.companions);
    case PieceChoice::largest:
      return pieces.front();
    case PieceChoice::index:
      require(std::size_t(options.pieceIndex) < pieces.size(),
              "mesh.pieceIndex is {}, but the surface has {} pieces, numbered from 0", options.pieceIndex,
              pieces.size());
      return pieces[std::size_t(options.pieceIndex)];
    case PieceChoice::point:
      return pieces[pieceNearest(pieces,
                                 {options.piecePoint[0], options.piecePoint[1], options.piecePoint[2]})];
    case PieceChoice::all:
      return joinPieces(pieces);
  }
  throw std::logic_error("unknown PieceChoice");
}

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

}  // namespace

struct Pipeline::Stages {
  Stage<Volume<float>> enhanced{1};
  Stage<Prepared> prepared{1};
  Stage<Volume<float>> classified{3};
  Stage<Points> points{3};
  Stage<FittedSurface> fitted{3};
  Stage<std::vector<Mesh>> pieces{3};
  Stage<Mesh> piece{3}, mesh{3}, print{1};
  LiveMemory live;
  Stage<Volume<float>> liveClassified{3};
  CoarseLevel half, quarter;
};

namespace {

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

Key preparedKey(const Input& input, const Parameters& p) {
  Hasher hasher("prepare 3");
  hasher.add(input.key).add(p.classification.lowPass).add(p.classification.directionScale);
  addOptions(hasher, p.scan);
  return hasher.key();
}

template <class Options>
Key keyOf(const char* stage, const Key& input, const Options& options) {
  Hasher hasher(stage);
  hasher.add(input);
  addOptions(hasher, options);
  return hasher.key();
}

Key pieceKeyOf(const Key& surface, const MeshOptions& mesh) {
  Hasher hasher("piece 2");
  hasher.add(surface).add(mesh.piece).add(mesh.companions).add(mesh.pieceIndex);
  return hasher.add(std::span<const double>(mesh.piecePoint)).key();
}

Key cleanKeyOf(const Key& piece, const MeshOptions& mesh) {
  Hasher hasher("clean 1");
  return hasher.add(piece)
      .add(mesh.minArea)
      .add(mesh.fillHoles)
      .add(mesh.smoothing)
      .add(mesh.triangles)
      .key();
}

// Only the options of the chosen method count.
Key fitKeyOf(const Key& points, const Parameters& p) {
  if (p.reconstruction.method == ReconstructionMethod::global) return keyOf("fit global 1", points, p.global);
  return keyOf("fit 2", points, p.reconstruction);
}

Input enhance(const Scan& scan, const EnhancementOptions& options, double until, Stage<Volume<float>>& memory,
              Run& run) {
  if (options.method == EnhancementMethod::none) return {scan.volume, scan.key};
  const Key key = keyOf("enhance 1", scan.key, options);
  return {run.stage("enhancement", until, memory, key,
                    [&](const Progress& p) { return diffuse(*scan.volume, options, p); }),
          key};
}

}  // namespace

Pipeline::Pipeline() : stages_(std::make_unique<Stages>()) {}
Pipeline::~Pipeline() = default;

Results Pipeline::run(const Scan& scan, const Parameters& parameters, Goal goal, const Progress& progress,
                      const StageBegins& stageBegins) {
  checkRanges(parameters);
  Results results;
  Run run(goal == Goal::classified ? progress.part(0, 2) : progress, stageBegins, results);

  const Input input = enhance(scan, parameters.enhancement, 0.1, stages_->enhanced, run);
  const Key prepareKey = preparedKey(input, parameters);
  const auto prepared = run.stage("low-pass", 0.15, stages_->prepared, prepareKey, [&](const Progress& p) {
    return prepare(scan, *input.volume, parameters, p);
  });

  ClassificationOptions classification = parameters.classification;
  if (classification.isoValue <= 0) classification.isoValue = double(prepared->levels.isoValue);
  results.isoValue = classification.isoValue;
  results.visibleLevel = double(prepared->levels.visible);
  // Sliders are answered fast; what a mesh is made from is solved to the tolerance.
  Key classifyKey = keyOf("classify 2", prepareKey, classification);
  results.isFinal = goal == Goal::mesh || stages_->classified.find(classifyKey);
  if (results.isFinal) {
    results.classified = run.stage(
        "classification", 0.5, stages_->classified, classifyKey,
        [&](const Progress& p) { return classify(*input.volume, prepared->smoothed, classification, p); });
  } else {
    classifyKey = keyOf("classify live 1", prepareKey, classification);
    results.classified =
        run.stage("classification", 0.5, stages_->liveClassified, classifyKey, [&](const Progress& p) {
          return stages_->live.classify(prepareKey, input.volume, prepared, classification, p);
        });
  }
  if (goal == Goal::classified) return results;

  const Key regionKey = keyOf("region", scan.erasedKey, parameters.region);
  const Key pointsKey =
      keyOf("points 3", Hasher("in").add(classifyKey).add(regionKey).key(), parameters.surface);
  const auto points = run.stage("points", 0.6, stages_->points, pointsKey, [&](const Progress& p) {
    return findPoints(scan, *results.classified, *prepared, results.isoValue, parameters, p);
  });
  results.thinned = points->thinned;
  results.points = points->points;
  results.echoOffset = points->echoOffset;
  if (goal == Goal::points) return results;

  require(results.points->size() > 0,
          "no surface was found: move classification.isoValue (now {:.2f}) toward the grey of the skin's "
          "edge, or "
          "lower surface.minClusterArea",
          results.isoValue);
  const Key fitKey = fitKeyOf(pointsKey, parameters);
  const auto fitted = run.stage("fit", 0.8, stages_->fitted, fitKey, [&](const Progress& p) {
    return fitSurface(*results.points, parameters.reconstruction, parameters.global, p);
  });
  results.centres = fitted->centres;
  results.globalError = fitted->report.globalError;
  results.globalErrorWithWeights = fitted->report.globalErrorWithWeights;

  const MeshOptions& mesh = parameters.mesh;
  Hasher surface("surface 2");
  const Key surfaceKey =
      surface.add(fitKey).add(mesh.resolution).add(mesh.cell).add(mesh.support).add(mesh.maxGap).key();
  const bool cleans = needsCleaning(mesh), prints = parameters.print.form != PrintForm::none;
  const double solid = prints ? 0.85 : 1, cleaned = cleans ? 0.9 * solid : solid;
  results.pieces = run.stage("surface", 0.98 * cleaned, stages_->pieces, surfaceKey, [&](const Progress& p) {
    const ImplicitFunction function = fitted->function(meshCell(results.points->positions, mesh));
    return splitPieces(extractIsoSurface(function, *results.points, mesh, p));
  });
  const Key pieceKey = pieceKeyOf(surfaceKey, mesh);
  const auto piece = run.stage("piece", cleaned, stages_->piece, pieceKey, [&](const Progress&) {
    return choosePiece(*results.pieces, mesh, prepared->beam, centreOf(scan.volume->geometry));
  });
  results.mesh = piece;
  const Key cleanKey = cleanKeyOf(pieceKey, mesh);
  if (cleans)
    results.mesh = run.stage("clean", solid, stages_->mesh, cleanKey,
                             [&](const Progress& p) { return cleanMesh(*piece, mesh, p); });
  if (prints)
    results.print =
        run.stage("print", 1, stages_->print, keyOf("print 1", cleanKey, parameters.print),
                  [&](const Progress& p) { return makePrintSolid(*results.mesh, parameters.print, p); });
  return results;
}

Results Pipeline::preview(const Scan& scan, const Parameters& parameters, Preview level,
                          const Progress& progress) {
  checkRanges(parameters);
  Results results;
  Run run(progress, {}, results);
  const Input input = enhance(scan, parameters.enhancement, 0.1, stages_->enhanced, run);
  const auto halve = [&](Stage<Volume<float>>& memory, const Volume<float>& volume, double until) {
    return run.stage("coarser voxels", until, memory, input.key,
                     [&](const Progress& p) { return halveResolution(volume, p); });
  };
  CoarseLevel& coarse = level == Preview::half ? stages_->half : stages_->quarter;
  Scan coarser = scan;
  coarser.volume = halve(stages_->half.volume, *input.volume, 0.2);
  if (level == Preview::quarter) coarser.volume = halve(stages_->quarter.volume, *coarser.volume, 0.3);
  Parameters adapted = parameters;
  adapted.classification = coarserOptions(
      parameters.classification, coarser.volume->geometry.minSpacing() / scan.volume->geometry.minSpacing());
  adapted.classification.tolerance = kPreviewTolerance;
  const Key key = preparedKey(input, parameters);
  const auto prepared = run.stage("low-pass", 0.5, coarse.prepared, key, [&](const Progress& p) {
    return prepare(coarser, *coarser.volume, adapted, p);
  });
  // The levels of the volume itself, where they are known: the full answer will use them.
  const auto full = stages_->prepared.find(key);
  const GreyLevels levels = full ? full->levels : prepared->levels;
  ClassificationOptions& classification = adapted.classification;
  if (classification.isoValue <= 0) classification.isoValue = double(levels.isoValue);
  results.isoValue = classification.isoValue;
  results.visibleLevel = double(levels.visible);
  results.classified =
      coarse.live.classify(key, coarser.volume, prepared, classification, progress.part(0.5, 1));
  return results;
}

}  // namespace sonoskin
