#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include "core/io/stored_volume.h"
#include "core/io/volume_entry.h"
#include "core/mesh/mesh.h"

// What readers in a process of their own answer, as bytes. Whoever takes an answer apart trusts nothing in it: the
// process may have been led astray by its file.
namespace sonoskin {

using Write = std::function<void(const void* data, std::size_t bytes)>;

// writeAnswer: what was read, piece by piece.
void writeAnswer(const LoadedVolume& volume, const Write& write);
void writeAnswer(const Mesh& mesh, const Write& write);
void writeAnswer(const std::vector<VolumeEntry>& entries, const Write& write);

// volumeFrom, meshFrom, entriesFrom: of an answer.
//   errors  Error: it contradicts itself: sizes that do not fit, indices without a vertex, numbers that are not finite; or
//           checkGeometry or checkMesh refuse it
LoadedVolume volumeFrom(std::span<const std::uint8_t> answer, const std::filesystem::path& path);
Mesh meshFrom(std::span<const std::uint8_t> answer, const std::filesystem::path& path);
std::vector<VolumeEntry> entriesFrom(std::span<const std::uint8_t> answer, const std::filesystem::path& path);

}  // namespace sonoskin
