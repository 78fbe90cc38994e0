#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/progress.h"
#include "core/io/headers/declared_data.h"

namespace sonoskin {

// readNumbers: the numbers of one time step as LoadedVolume has them: colours side by side, i fastest, this
// machine's byte order, after slope and intercept.
//   input    step  counted from 0; there must be one
//   errors   Error: sizes out of range; fewer bytes or numbers than declared; a packed stream that is damaged
//            or does not come to its end; Cancelled
//   cost     raw files: what is read of them; packed and written ones are read to their end. Memory of the
//            time step where time is the slowest axis, twice that of all steps where it is not
std::vector<std::uint8_t> readNumbers(const DeclaredData& data, const std::filesystem::path& path, int step,
                                      const Progress& progress = {});

}  // namespace sonoskin
