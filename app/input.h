#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/pipeline/parameters.h"
#include "core/volume/scan.h"

namespace sonoskin {

// kPhantomInput: stands for the simulated scan where a file name is expected.
inline constexpr const char* kPhantomInput = "phantom";

// loadInput: the scan that `input` names: "phantom", or a volume file.
//   errors  Error: see readScan; Cancelled
Scan loadInput(const std::string& input, const Parameters& parameters, const Progress& progress = {});

// inputName: what a report may say of an input: the file's name without its folders.
std::string inputName(const std::string& input);

}  // namespace sonoskin
