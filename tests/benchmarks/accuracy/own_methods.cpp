#include "core/pipeline/pipeline.h"
#include "tests/benchmarks/accuracy/methods.h"

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

}  // namespace

std::vector<Method> ownMethods() {
  return {{"default", "our chain, default parameters", runPipeline},
          {"beta0", "the same, beta 0: no smoothing along the surface", withoutBeta},
          {"onethreshold", "the same, one threshold: no strong voxels asked for", withoutHysteresis},
          {"nofacing", "the same without the facing filter", withoutFacing}};
}

}  // namespace sonoskin::accuracy
