#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/io/reader_process.h"
#include "core/io/reader_wire.h"

namespace sonoskin {

// performTask: reads in this process, and writes the answer piece by piece.
//   errors  those of loadVolume or parseMesh
void performTask(const ReaderRequest& request, const std::filesystem::path& path, const Write& write,
                 const Progress& progress);

}  // namespace sonoskin
