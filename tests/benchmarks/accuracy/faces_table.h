#pragma once

#include <string>
#include <vector>

#include "tests/benchmarks/accuracy/faces_score.h"

namespace sonoskin::accuracy {

// FaceRow: one run.
//   settings   "surface.facing=0.1" of a sweep, or empty
struct FaceRow {
  std::string scene, settings;
  int shape = 0, seed = 0;
  FaceScore score;
};

// faceTables: for every scene and setting, in order of appearance, and for all scenes together: median and, in brackets,
// the worst over its rows (the mean of shares of runs); "-" where nothing is known. Markdown.
std::string faceTables(const std::vector<FaceRow>& rows);

// faceCsv: a line of names, and one line for each row; empty where nothing is known.
std::string faceCsv(const std::vector<FaceRow>& rows);

}  // namespace sonoskin::accuracy
