#include "tests/benchmarks/accuracy/faces_table.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sonoskin::accuracy {
namespace {

// contains: for messages that show the text.
testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << part << " is not in\n" << text;
}

FaceRow row(const std::string& scene, int seed, double rms, double covered, double offset = 0) {
  FaceRow row{scene, "", 0, seed, {}};
  row.score.rms = rms, row.score.covered = covered, row.score.offset = offset;
  return row;
}

TEST(FacesTable, SaysMedianAndWorstOfEveryScene) {
  const std::string tables = faceTables({row("clear", 1, 0.2, 0.9, 0.1), row("clear", 2, 0.4, 0.8, -0.3),
                                         row("clear", 3, 0.3, 0.95, 0.2), row("haze", 1, 0.6, 0.5)});
  // scene, runs, RMS, p95, max, offset, border, interior, covered
  EXPECT_TRUE(contains(tables, "| clear | 3 | 0.30 (0.40) | - | - | 0.10 (-0.30) | - | - | 90 (80) |"));
  EXPECT_TRUE(contains(tables, "| haze | 1 | 0.60 (0.60) |"));
  EXPECT_TRUE(contains(tables, "| all | 4 | 0.35 (0.60) |"));
}

TEST(FacesTable, SaysHowManyRunsHaveNoSpur) {
  std::vector<FaceRow> rows{row("clear", 1, 0, 1), row("clear", 2, 0, 1), row("clear", 3, 0, 1)};
  rows[0].score.spurless = rows[1].score.spurless = 1, rows[2].score.spurless = 0;
  EXPECT_TRUE(contains(faceTables(rows), "| 67 |"));
}

TEST(FacesTable, KeepsTheValuesOfASweepApart) {
  FaceRow other = row("clear", 1, 0.5, 1);
  other.settings = "mesh.maxGap=6";
  const std::string tables = faceTables({row("clear", 1, 0.2, 1), other});
  EXPECT_TRUE(contains(tables, "| clear | 1 | 0.20 (0.20) |"));
  EXPECT_TRUE(contains(tables, "| clear, mesh.maxGap=6 | 1 | 0.50 (0.50) |"));
  EXPECT_FALSE(contains(tables, "| all |")) << "one scene needs no sum";
}

TEST(FacesTable, CsvHasOneLineForEachRun) {
  const std::string csv = faceCsv({row("clear", 1, 0.25, 0.9), row("haze", 2, kUnknown, 0)});
  EXPECT_TRUE(contains(csv, "scene,shape,seed,settings,rms_mm,p95_mm,"));
  EXPECT_TRUE(contains(csv, "\nclear,0,1,,0.25,,"));
  EXPECT_TRUE(contains(csv, "\nhaze,0,2,,,,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
}

}  // namespace
}  // namespace sonoskin::accuracy
