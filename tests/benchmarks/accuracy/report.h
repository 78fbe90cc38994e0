#pragma once

#include <string>
#include <vector>

#include "tests/benchmarks/accuracy/score.h"

namespace sonoskin::accuracy {

// Row: one method at one level.
struct Row {
  std::string level, method, help, settings;  // settings: "surface.facing=0.1" of a sweep, or empty
  double snr = 0, contrast = 0;               // of the level
  double seconds = 0;                         // CPU, all threads
  double isoValue = 0;                        // the one used, 0 where the method does not say
  Score score;
};

// machineLine: one row as "key=value" words, for scripts.
std::string machineLine(const Row& row);

// levelTable: the rows of one level in full; summaryTable: F debiased of every method at every level.
std::string levelTable(const std::vector<Row>& rows);
std::string summaryTable(const std::vector<Row>& rows);

}  // namespace sonoskin::accuracy
