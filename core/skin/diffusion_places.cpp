#include "core/skin/diffusion_places.h"

#include <algorithm>
#include <array>

#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

constexpr int kBits = 10;  // per axis
constexpr std::uint32_t kCells = 1u << kBits;
constexpr std::size_t kPerTask = 16384;

// Two zero bits after each of the ten.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000FFu;
  bits = (bits | bits << 8) & 0x0300F00Fu;
  bits = (bits | bits << 4) & 0x030C30C3u;
  return (bits | bits << 2) & 0x09249249u;
}

struct Coded {
  std::uint32_t code, place;
};

std::vector<Coded> codesOf(std::span<const glm::vec3> positions) {
  glm::vec3 low(positions[0]), high(positions[0]);
  for (const glm::vec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
  const glm::vec3 size = high - low;
  const float cells = float(kCells) / std::max({size.x, size.y, size.z, 1e-20f});
  std::vector<Coded> codes(positions.size());
  parallelItems(positions.size(), kPerTask, [&](std::size_t i) {
    const glm::uvec3 cell = glm::min(glm::uvec3((positions[i] - low) * cells), kCells - 1);
    codes[i] = {spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2, std::uint32_t(i)};
  });
  return codes;
}

// By digits of ten bits, the last one first; places of one cell stay in their order.
void sortByCode(std::vector<Coded>& codes) {
  std::vector<Coded> sorted(codes.size());
  for (int digit = 0; digit < 3; ++digit) {
    std::array<std::uint32_t, kCells + 1> next{};
    const auto of = [&](const Coded& c) { return c.code >> (digit * kBits) & (kCells - 1); };
    for (const Coded& c : codes) ++next[of(c) + 1];
    for (std::size_t d = 0; d < kCells; ++d) next[d + 1] += next[d];
    for (const Coded& c : codes) sorted[next[of(c)]++] = c;
    codes.swap(sorted);
  }
}

}  // namespace

DiffusionPlaces inLocalOrder(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
  DiffusionPlaces places;
  if (positions.empty()) return places;
  std::vector<Coded> codes = codesOf(positions);
  sortByCode(codes);
  places.positions.resize(codes.size());
  places.normals.resize(codes.size());
  places.order.resize(codes.size());
  parallelItems(codes.size(), kPerTask, [&](std::size_t i) {
    const std::uint32_t place = codes[i].place;
    places.positions[i] = positions[place];
    places.normals[i] = normals[place];
    places.order[i] = place;
  });
  return places;
}

}  // namespace sonoskin
