// The mesh as it is drawn with an atlas.
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/mesh/atlas/atlas.h"
#include "core/mesh/facets.h"

namespace sonoskin {

AtlasVertices splitAtSeams(const Mesh& mesh, const Atlas& atlas) {
  require(atlas.corners.size() == mesh.triangles.size(), "The atlas belongs to another mesh.");
  std::vector<std::uint32_t> vertexOfCorner(3 * mesh.triangles.size());
  for (std::uint32_t h = 0; h < vertexOfCorner.size(); ++h) vertexOfCorner[h] = originOf(mesh.triangles, h);
  const Groups corners(vertexOfCorner, mesh.positions.size());
  const glm::vec2 scale = 1.f / glm::vec2(atlas.size);
  AtlasVertices split;
  split.triangles.resize(mesh.triangles.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const std::size_t first = split.uv.size();
    for (const std::uint32_t* h = corners.begin(v); h != corners.end(v); ++h) {
      const glm::vec2 uv = atlas.corners[*h / 3][*h % 3] * scale;
      const auto found = std::find(split.uv.begin() + std::ptrdiff_t(first), split.uv.end(), uv);
      split.triangles[*h / 3][*h % 3] = std::uint32_t(found - split.uv.begin());
      if (found != split.uv.end()) continue;
      split.uv.push_back(uv);
      split.source.push_back(v);
    }
  }
  return split;
}

}  // namespace sonoskin
