#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/io/read_options.h"
#include "core/io/stored_volume.h"

// Files of numbers without a header.
namespace sonoskin {

// readRawFile: reads one by what the options tell of it.
//   output  on a sector or a pyramid the samples, with stored.grid
//   errors  Error (usage): nothing was told of it; the sentence names the parameters and dimensions of which it has the size.
//           Error: the file has another size, the grid cannot be one, there is no such time step
LoadedVolume readRawFile(const std::filesystem::path& path, const ReadOptions& options,
                         const Progress& progress = {});

// needsRawOptions: whether a file can be read only once it is told what is in it: a person must be asked before readScan.
//   errors  as readBytes
bool needsRawOptions(const std::filesystem::path& path, const RawOptions& options);

// RawGuess: dimensions that a file of some size may have.
struct RawGuess {
  std::array<int, 3> dims{0, 0, 0};
  NumberType type = NumberType::uint8;
};

// guessRaw: the likeliest first: cubes, then stacks of square pictures of usual sizes; bytes before numbers of two or four.
std::vector<RawGuess> guessRaw(std::uintmax_t bytes);

}  // namespace sonoskin
