#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/mesh/atlas/atlas.h"

namespace sonoskin {
namespace {

constexpr int kSmallest = 4;  // texels along a block: two triangles with a free diagonal between them

// The side of the block of a triangle: a power of two, so that blocks of one size fill shelves without gaps.
int blockSide(const Mesh& mesh, const Triangle& t, double texel, int largest) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    longest = std::max(longest, double(glm::length(mesh.positions[t[(i + 1) % 3]] - mesh.positions[t[i]])));
  int side = kSmallest;
  while (side < largest && side - 2 < longest / texel) side *= 2;
  return side;
}

// The two halves of a block, each half a texel from the sides and one from the diagonal between them; both
// counter-clockwise.
Corners halfOfBlock(const glm::ivec2& low, int side, bool upper) {
  const glm::vec2 a(low), b = a + float(side);
  if (upper) return {glm::vec2(b.x - 0.5f, b.y - 0.5f), {a.x + 1.5f, b.y - 0.5f}, {b.x - 0.5f, a.y + 1.5f}};
  return {glm::vec2(a.x + 0.5f, a.y + 0.5f), {b.x - 1.5f, a.y + 0.5f}, {a.x + 0.5f, b.y - 1.5f}};
}

using BySide =
    std::map<int, std::vector<std::uint32_t>, std::greater<>>;  // triangles, the largest blocks first

// The height of shelves of `width` texels that hold the blocks; places them if there is an atlas.
int fillShelves(const BySide& bySide, int width, Atlas* atlas) {
  int y = 0;
  for (const auto& [side, triangles] : bySide) {
    const std::size_t perShelf = std::size_t(width / side), blocks = (triangles.size() + 1) / 2;
    for (std::size_t i = 0; atlas && i < triangles.size(); ++i) {
      const glm::ivec2 cell(int(i / 2 % perShelf), int(i / 2 / perShelf));
      atlas->corners[triangles[i]] = halfOfBlock(glm::ivec2(0, y) + side * cell, side, i % 2 == 1);
    }
    y += side * int((blocks + perShelf - 1) / perShelf);
  }
  return y;
}

}  // namespace

Atlas blockAtlas(const Mesh& mesh, double texel, int maxSize, double maxTexels) {
  require(texel > 0 && maxSize >= kSmallest, "A texel needs a size, and an atlas at least 4 texels.");
  Atlas atlas;
  atlas.corners.resize(mesh.triangles.size());
  for (double size = texel;; size *= 1.2) {
    BySide bySide;
    double area = 1;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const int side = blockSide(mesh, mesh.triangles[t], size, std::max(kSmallest, maxSize / 2));
      bySide[side].push_back(t);
      area += 0.5 * side * side;
    }
    const int largest = bySide.empty() ? kSmallest : bySide.begin()->first;
    int width = largest;
    while (width < maxSize && double(width) * width < area) width = std::min(2 * width, maxSize);
    const int height = fillShelves(bySide, width, nullptr);
    const bool isSmallest = largest == kSmallest;
    require(height <= maxSize || !isSmallest,
            "{} triangles are too many for an atlas of {} texels a side; reduce the mesh first.",
            mesh.triangles.size(), maxSize);
    if (height > maxSize || (double(width) * height > maxTexels && !isSmallest)) continue;
    fillShelves(bySide, width, &atlas);
    atlas.size = {width, std::max(1, height)};
    atlas.texel = float(size);
    break;
  }
  atlas.charts = int(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) atlas.chart.push_back(t);
  return atlas;
}

}  // namespace sonoskin
