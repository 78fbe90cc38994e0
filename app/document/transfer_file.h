#pragma once

#include <filesystem>

#include "render/transfer_presets.h"

namespace sonoskin {

// Transfer functions in files: JSON, {"level": 0.3, "points": [{"value": 0.2, "opacity": 0, "colour": [r, g, b]}, ...]},
// all numbers 0 to 1, colours sRGB.

// readTransfer: what a file holds.
//   output  2 to 64 points by rising value
//   errors  Error: there is no such file, or it is no transfer function
LevelledTransfer readTransfer(const std::filesystem::path& file);

// writeTransfer: atomically; makes the folder where it is missing.
//   errors  Error (system): it cannot be written
void writeTransfer(const std::filesystem::path& file, const LevelledTransfer& transfer);

}  // namespace sonoskin
