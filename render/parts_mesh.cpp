#include "render/parts_mesh.h"

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

// Half floats hold multiples of 1/64 below 1 exactly.
float codeOf(const PartTint& tint) { return float(tint.colour + (tint.dimmed ? kPartColours : 0)) / 64; }

}  // namespace

Mesh makePartsMesh(const Mesh& mesh, const std::vector<std::uint32_t>& partOfTriangle,
                   const std::vector<PartTint>& tints) {
  Mesh result;
  result.positions = mesh.positions;
  result.normals = mesh.normals;
  result.triangles = mesh.triangles;
  result.visibility.assign(mesh.positions.size(), 0);
  // Every vertex belongs to the first part that uses it; for others it has copies, in a list from copy to copy.
  std::vector<std::uint32_t> part(mesh.positions.size(), kNone), next(mesh.positions.size(), kNone);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint32_t& v : result.triangles[t]) {
      const std::uint32_t wanted = partOfTriangle[t];
      while (part[v] != wanted && part[v] != kNone && next[v] != kNone) v = next[v];
      if (part[v] != wanted && part[v] != kNone) {
        const auto copy = std::uint32_t(result.positions.size());
        result.positions.push_back(result.positions[v]);
        if (!result.normals.empty()) result.normals.push_back(result.normals[v]);
        result.visibility.push_back(0);
        part.push_back(kNone);
        next.push_back(kNone);
        next[v] = copy;
        v = copy;
      }
      part[v] = wanted;
      result.visibility[v] = codeOf(tints[wanted]);
    }
  return result;
}

}  // namespace sonoskin
