#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/pipeline/pipeline.h"
#include "tests/support/test_volumes.h"

namespace sonoskin {

inline const glm::dvec3 kCentre(9, 10, 9.5);
inline constexpr double kRadius = 6;

// ballScan: a noisy ball in fluid, seen by parallel beams along +j.
inline Scan ballScan() {
  Scan scan;
  auto volume = std::make_shared<Volume<float>>(
      test::speckledSphere(test::grid({60, 60, 40}, {0.3, 0.3, 0.5}), kCentre, kRadius, 0.15));
  scan.key = scanKey(*volume, {});
  scan.volume = volume;
  return scan;
}

inline Parameters parametersForTests() {
  Parameters p;
  p.mesh.resolution = 80;
  p.mesh.fillHoles = 0;  // no stage of its own
  return p;
}

// PipelineTest: a pipeline, and that ball for it.
class PipelineTest : public ::testing::Test {
 protected:
  const Scan scan = ballScan();
  Parameters parameters = parametersForTests();
  Pipeline pipeline;

  // The stages that a run computed, not remembered.
  static std::vector<std::string> computed(const Results& results) {
    std::vector<std::string> names;
    for (const StageReport& s : results.stages)
      if (s.seconds > 0) names.push_back(s.name);
    return names;
  }
};

}  // namespace sonoskin
