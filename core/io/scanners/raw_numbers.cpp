#include "core/io/scanners/raw_numbers.h"

#include <algorithm>
#include <fstream>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/io/headers/data_files.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

void swapBytes(std::vector<std::uint8_t>& bytes, std::size_t each) {
  for (std::size_t at = 0; at + each <= bytes.size(); at += each)
    std::reverse(bytes.begin() + std::ptrdiff_t(at), bytes.begin() + std::ptrdiff_t(at + each));
}

// What follows the numbers is left alone, but not in silence.
void noteRest(std::uint64_t rest, std::uint64_t frame) {
  if (rest == 0) return;
  const std::string steps =
      rest % frame == 0 ? fmt::format(", as much as {} time steps more", rest / frame) : "";
  log(LogLevel::warning,
      fmt::format("The file holds {} bytes after its numbers{}; they are left out.", rest, steps));
}

}  // namespace

std::uint64_t countNumbers(const glm::ivec3& dims, int components, const fs::path& path) {
  constexpr std::uint64_t kMost = std::uint64_t(1) << 31;
  for (int a = 0; a < 3; ++a)
    require(dims[a] >= 2 && dims[a] <= 65535,
            "{} should have {} x {} x {} voxels; 2 to 65535 along each axis are possible.", path.string(),
            dims.x, dims.y, dims.z);
  const std::uint64_t voxels = std::uint64_t(dims.x) * std::uint64_t(dims.y) * std::uint64_t(dims.z);
  require(voxels <= kMost, "{} should have {} x {} x {} voxels, more than fit into memory; crop it first.",
          path.string(), dims.x, dims.y, dims.z);
  return voxels * std::uint64_t(components);
}

std::vector<std::uint8_t> readNumbers(const RawNumbers& n, const fs::path& path) {
  const std::uint64_t size = dataFileSize(n.file, path), frame = n.frame * numberTypeBytes(n.type);
  checkTime(n.step, n.timeSteps, path);
  const std::uint64_t all = frame * std::uint64_t(n.timeSteps);
  const std::uint64_t header = n.header >= 0 ? std::uint64_t(n.header) : size - std::min(all, size);
  require(header <= size && all <= size - header,
          "{} has {} bytes, but {} time step{} of {} numbers of {} after {} bytes take {}; correct what is "
          "said of it, or get a fresh copy.",
          path.string(), size, n.timeSteps, n.timeSteps == 1 ? "" : "s", n.frame, numberTypeName(n.type),
          header, all);
  noteRest(size - header - all, frame);
  std::vector<std::uint8_t> numbers(frame);
  std::ifstream file(n.file, std::ios::binary);
  file.seekg(std::streamoff(header + frame * std::uint64_t(n.step - 1)));
  file.read(reinterpret_cast<char*>(numbers.data()), std::streamsize(numbers.size()));
  require(bool(file), "The file {} cannot be read to its end; check its permissions, or get a fresh copy.",
          path.string());
  if (n.byteOrder == ByteOrder::big) swapBytes(numbers, numberTypeBytes(n.type));
  return numbers;
}

}  // namespace sonoskin
