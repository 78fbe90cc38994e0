#include "core/pipeline/pipeline.h"
#include "core/pipeline/presets.h"
#include "tests/benchmarks/accuracy/methods.h"
#include "tests/benchmarks/accuracy/rival_support.h"

namespace sonoskin::accuracy {
namespace {

Finding runPipeline(const Scan& scan, const Parameters& parameters) {
  Pipeline pipeline;
  const Results results = pipeline.run(scan, parameters, Goal::points);
  return {*results.points, results.isoValue};
}

Finding withoutBeta(const Scan& scan, const Parameters& parameters) {
  Parameters changed = parameters;
  changed.classification.beta = 0;
  return runPipeline(scan, changed);
}

Finding withoutHysteresis(const Scan& scan, const Parameters& parameters) {
  Parameters changed = parameters;
  changed.surface.strongShare = 0;
  changed.surface.strongThreshold = changed.surface.threshold;
  return runPipeline(scan, changed);
}

Finding withoutFacing(const Scan& scan, const Parameters& parameters) {
  Parameters changed = parameters;
  changed.surface.facing = -1;
  return runPipeline(scan, changed);
}

Finding withDiffusion(const Scan& scan, const Parameters& parameters) {
  Parameters changed = parameters;
  changed.enhancement.method = EnhancementMethod::diffusion;
  return runPipeline(scan, changed);
}

// The chain of the thesis: its equation in closed form, u blurred by a box, 13 directions, threshold 0.15; with the
// iso-value that we find, as it has no way of finding one, and the rivals' rule for pieces, as its own (the largest
// piece alone) often picks the wall of the uterus.
Finding thesisChain(const Scan& scan, const Parameters& parameters) {
  Parameters changed = parameters;
  applyPreset(findPreset("thesis-baby-2"), changed);
  changed.classification.isoValue = parameters.classification.isoValue;
  const double threshold = changed.surface.threshold;
  const SurfaceOptions rules = rivalOptions(parameters, scan.volume->geometry, threshold);
  changed.surface.clusters = ClusterRule::hysteresis;
  changed.surface.strongThreshold = threshold;
  changed.surface.strongShare = 0;
  changed.surface.minClusterArea = rules.minClusterArea;
  changed.surface.facing = rules.facing;
  changed.surface.borderMargin = rules.borderMargin;
  return runPipeline(scan, changed);
}

Finding thesisWithoutFacing(const Scan& scan, const Parameters& parameters) {
  Parameters changed = parameters;
  changed.surface.facing = -1;
  return thesisChain(scan, changed);
}

}  // namespace

std::vector<Method> ownMethods() {
  return {{"default", "our chain, default parameters", runPipeline},
          {"beta0", "the same, beta 0: no smoothing along the surface", withoutBeta},
          {"onethreshold", "the same, one threshold: no strong voxels asked for", withoutHysteresis},
          {"nofacing", "the same without the facing filter", withoutFacing},
          {"enhanced", "the same after our speckle reduction", withDiffusion},
          {"thesis",
           "the thesis' chain: closed form, blurred u, 13 directions, 0.15; our iso-value and facing filter",
           thesisChain},
          {"thesisnofacing", "the same without the facing filter", thesisWithoutFacing}};
}

}  // namespace sonoskin::accuracy
