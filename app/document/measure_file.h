#pragma once

#include <string>
#include <vector>

#include "app/document/measures.h"

namespace sonoskin {

// kMostMeasures, kMostMarks: that a session holds, and of one of them.
inline constexpr std::size_t kMostMeasures = 10'000, kMostMarks = 10'000;

// measuresIn: the measures that the text of a session holds, those that are complete; of any other text none. Logs how
// many could not be read.
std::vector<Measure> measuresIn(const std::string& text);

// measuresJson: for reports: [{"kind": "distance", "value": 12.3, "unit": "mm", "marks_mm": [[x, y, z], ...]}, ...]; the marks
// in the scan's frame, LPS, to a thousandth of a millimetre; units are mm, degrees and mm2.
std::string measuresJson(const std::vector<Measure>& measures);

// measuresText: the same for people, a line each.
std::string measuresText(const std::vector<Measure>& measures);

}  // namespace sonoskin
