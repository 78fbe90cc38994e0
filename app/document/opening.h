#pragma once

#include "app/document/document.h"
#include "core/base/progress.h"

namespace sonoskin {

// What a scan is from its file, or its simulation, to its place in a document.

// readVolumeTo: reads `opened.source`, described by `opened.raw`, into its scan.
//   options  which scan of the file, and how it is read; its spacing counts where the file gives none
//   errors   see loadInput
void readVolumeTo(Opened& opened, const ScanOptions& options, const Progress& progress);

// simulateTo: simulates `opened.phantom` into its scan.
void simulateTo(Opened& opened, const ScanOptions& options, const Progress& progress);

}  // namespace sonoskin
