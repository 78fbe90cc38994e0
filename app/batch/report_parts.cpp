#include "app/batch/report_parts.h"

#include <algorithm>

#include "core/base/error_text.h"
#include "core/base/parallel.h"

namespace sonoskin {

void reportScan(Report& report, const Scan& scan) {
  const Geometry& g = scan.volume->geometry;
  report.dims = {g.dims.x, g.dims.y, g.dims.z};
  report.spacing = {g.spacing.x, g.spacing.y, g.spacing.z};
  report.spacingKnown = scan.spacingKnown;
  if (!scan.erased) return;
  const auto& erased = scan.erased->data;
  report.erasedVoxels = erased.size() - std::size_t(std::count(erased.begin(), erased.end(), 0));
}

void reportResults(Report& report, const Results& results, const Parameters& parameters) {
  report.stages.insert(report.stages.end(), results.stages.begin(), results.stages.end());
  report.isoValue = results.isoValue;
  report.isoShare = parameters.classification.isoShare;
  report.isoRange = results.isoRange;
  report.points = results.points->size();
  report.edge = results.edge;
  report.centres = results.centres;
  report.globalError = results.globalError;
  report.globalErrorWithWeights = results.globalErrorWithWeights;
  report.pieces = results.pieces ? results.pieces->size() : 0;
  report.face = reportFace(results.face.get(), parameters.face);
  report.parts = reportParts(results);
}

Report reportWork(const ReportedWork& work, const Progress& progress) {
  Report report;
  report.input = work.scan.key.hex();
  reportScan(report, work.scan);
  reportResults(report, work.results, work.parameters);
  report.measures = work.measures;
  for (const std::string& warning : work.results.warnings) report.warnings.push_back(asSentence(warning));
  report.mesh = measureMesh(*work.results.mesh, progress);
  report.measured = measureFilled(*work.results.mesh);
  for (const StageReport& stage : report.stages) report.seconds += stage.seconds;
  report.peakMemory = peakMemoryBytes();
  report.threads = threadCount();
  report.gl = work.gl;
  return report;
}

}  // namespace sonoskin
