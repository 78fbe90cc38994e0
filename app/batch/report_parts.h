#pragma once

#include "app/batch/report.h"
#include "core/volume/scan.h"

namespace sonoskin {

// What a report says of the scan, and of what the pipeline has made of it.
//   results  with a mesh
void reportScan(Report& report, const Scan& scan);
void reportResults(Report& report, const Results& results, const Parameters& parameters);

// ReportedWork: what is open in the window.
struct ReportedWork {
  Scan scan;
  Results results;
  Parameters parameters;  // that the surface was made with
  std::vector<Measure> measures;
  std::string gl;
};

// reportWork: a report of it, as a run writes one, but for what a run alone costs; names no file.
//   errors  Cancelled
Report reportWork(const ReportedWork& work, const Progress& progress = {});

}  // namespace sonoskin
