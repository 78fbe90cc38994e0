#pragma once

#include <string>

namespace sonoskin {

// StepRange: time steps of a recording, counted from 1, both ends among them.
//   last  kLastStep: to the end, whatever that is
struct StepRange {
  static constexpr int kLastStep = 100'000;
  int first = 1, last = 1;
  bool isOne() const { return first == last; }
};

// stepRange: of "all", "N" or "A-B".
//   errors  Error (usage): it is none of these, or B comes before A
StepRange stepRange(const std::string& text);

// stepsWithin: the range, where the recording has all of it.
//   errors  Error: it has fewer steps
StepRange stepsWithin(StepRange range, int timeSteps);

}  // namespace sonoskin
