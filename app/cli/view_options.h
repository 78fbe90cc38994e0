#pragma once

#include <CLI/App.hpp>

#include "app/batch/scan_view.h"

namespace sonoskin {

// addViewOptions: what a picture shows, and from where: --view, --layer, --plane, --at, those of addVolumeOptions(), --camera,
// --light, --clip and --mark-unmeasured.
void addViewOptions(CLI::App& command, ScanView& view);

// checkViewOptions: refuses bad words and what does not go together before any work.
//   errors  Error (usage)
void checkViewOptions(const ScanView& view);

// isPlanar: whether it shows slices, which no camera looks at.
bool isPlanar(const ScanView& view);

}  // namespace sonoskin
