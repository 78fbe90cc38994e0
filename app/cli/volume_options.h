#pragma once

#include <CLI/App.hpp>

#include "app/batch/scan_view.h"

namespace sonoskin {

// addVolumeOptions: --mode, --level, --whole, --transfer, --no-shadows and --with-mesh, for --view volume.
void addVolumeOptions(CLI::App& command, VolumeShown& shown);

// checkVolumeOptions: refuses, before any work, what does not go together, or a transfer function that is none.
//   errors  Error
void checkVolumeOptions(const VolumeShown& shown);

}  // namespace sonoskin
