#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include "core/base/progress.h"
#include "core/io/reader_process.h"
#include "core/io/stored_volume.h"
#include "core/mesh/mesh.h"

// What readers in a process of their own answer, as bytes. Whoever takes an answer apart trusts nothing in it: the
// process may have been led astray by its file.
namespace sonoskin {

using Write = std::function<void(const void* data, std::size_t bytes)>;

// performTask: reads, and writes the answer piece by piece.
//   errors  those of loadVolume or parseMesh
void performTask(ReaderTask task, const std::filesystem::path& path, const Write& write,
                 const Progress& progress);

// volumeFrom, meshFrom: of an answer.
//   errors  Error: it contradicts itself: sizes that do not fit, indices without a vertex, numbers that are not finite
LoadedVolume volumeFrom(std::span<const std::uint8_t> answer, const std::filesystem::path& path);
Mesh meshFrom(std::span<const std::uint8_t> answer, const std::filesystem::path& path);

}  // namespace sonoskin
