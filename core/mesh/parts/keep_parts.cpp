#include "core/mesh/parts/keep_parts.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/repair/clip.h"
#include "core/mesh/vertex_rings.h"

namespace sonoskin {
namespace {

constexpr double kBand = 4;                 // mm on each side of a cut where it may move
constexpr float kFixed = 2, kSmoothed = 1;  // values that stay, and those that smoothing may change
constexpr int kMostSteps = 400;

// The mean length of the edges, from that of the triangles' first ones.
double meanEdge(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += double(glm::distance(mesh.positions[t[0]], mesh.positions[t[1]]));
  return sum / double(mesh.triangles.size());
}

// Rings of vertices around the cut: 0 on it, up to `most` beyond it.
std::vector<int> ringsFromCut(const Mesh& mesh, const std::vector<int>& side, int most) {
  std::vector<int> ring(side.size(), most + 1);
  for (std::size_t v = 0; v < side.size(); ++v)
    if (side[v] == 0) ring[v] = 0;
  for (int r = 0; r < most; ++r)
    for (const Triangle& t : mesh.triangles) {
      const int least = std::min({ring[t[0]], ring[t[1]], ring[t[2]]});
      if (least != r) continue;
      for (const std::uint32_t v : t) ring[v] = std::min(ring[v], r + 1);
    }
  return ring;
}

}  // namespace

Mesh keepParts(const Mesh& mesh, const SurfaceParts& parts, const std::vector<PartVerdict>& verdicts,
               const Progress& progress) {
  const auto kept = [&](std::size_t t) { return verdicts[parts.ofTriangle[t]].kept; };
  std::vector<int> side(mesh.positions.size(), 2);  // 1: kept, -1: off, 0: both meet there, 2: no triangle
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const int s = kept(t) ? 1 : -1;
    count += kept(t);
    for (const std::uint32_t v : mesh.triangles[t]) side[v] = side[v] == 2 || side[v] == s ? s : 0;
  }
  if (count == mesh.triangles.size()) return mesh;
  if (count == 0) return {};
  const double edge = meanEdge(mesh);
  const int rings = std::clamp(int(std::ceil(kBand / edge)), 2, 40);
  progress.update(0.2);
  const std::vector<int> ring = ringsFromCut(mesh, side, rings);
  std::vector<float> values(side.size());
  for (std::size_t v = 0; v < side.size(); ++v)
    values[v] = float(side[v] == 2 ? -1 : side[v]) * (ring[v] > rings ? kFixed : kSmoothed);
  // n steps spread a value over sqrt(n / 2) edges: two thirds of the band.
  const int steps = std::clamp(int(double(rings) * double(rings)), 4, kMostSteps);
  values = smoothAlong(VertexRings(mesh), std::move(values), 0.5f * (kFixed + kSmoothed), steps,
                       progress.part(0.2, 0.8));
  return clipMesh(mesh, values);
}

}  // namespace sonoskin
