#include "core/mesh/atlas/atlas_skirts.h"

#include <atomic>
#include <limits>
#include <queue>

namespace sonoskin {
namespace {

constexpr float kFar = std::numeric_limits<float>::max();
constexpr float kFacing = 0.15f;  // least cosine to the axis      [theory/skin.md, 3.2, step 6]

// The triangles at each vertex.
Groups trianglesAtVertices(const Mesh& mesh) {
  std::vector<std::uint32_t> vertexOfCorner(3 * mesh.triangles.size());
  for (std::uint32_t h = 0; h < vertexOfCorner.size(); ++h) vertexOfCorner[h] = originOf(mesh.triangles, h);
  Groups groups(vertexOfCorner, mesh.positions.size());
  for (std::uint32_t& corner : groups.items) corner /= 3;
  return groups;
}

// SkirtSearch: Dijkstra's shortest ways from the border of one chart after the other; keeps its memory between them.
class SkirtSearch {
 public:
  SkirtSearch(const Facets& facets, const Groups& atVertex, const Charts& charts, float reach)
      : facets_(facets),
        atVertex_(atVertex),
        charts_(charts),
        reach_(reach),
        way_(facets.mesh.positions.size(), kFar),
        isTaken_(facets.size(), 0) {}

  std::vector<std::uint32_t> search(std::uint32_t chart, const std::vector<std::uint32_t>& border,
                                    const glm::vec3& toward, const Progress& progress) {
    std::vector<std::uint32_t> skirt;
    for (const std::uint32_t v : border) approach(v, 0);
    for (std::size_t steps = 0; !queue_.empty(); ++steps) {
      if (steps % 4096 == 0) progress.throwIfCancelled();
      const auto [way, v] = queue_.top();
      queue_.pop();
      if (way > way_[v]) continue;
      for (const std::uint32_t* t = atVertex_.begin(v); t != atVertex_.end(v); ++t) {
        if (charts_.ofTriangle[*t] == chart || !faces(*t, toward)) continue;
        if (!isTaken_[*t]) skirt.push_back(*t);
        isTaken_[*t] = 1;
        const glm::vec3& from = facets_.mesh.positions[v];
        for (const std::uint32_t w : facets_.mesh.triangles[*t])
          if (w != v) approach(w, way + glm::length(facets_.mesh.positions[w] - from));
      }
    }
    for (const std::uint32_t v : reached_) way_[v] = kFar;
    for (const std::uint32_t t : skirt) isTaken_[t] = 0;
    reached_.clear();
    return skirt;
  }

 private:
  using Step = std::pair<float, std::uint32_t>;

  bool faces(std::uint32_t t, const glm::vec3& toward) const {
    const glm::vec3& n = facets_.normal[t];
    const float facing = glm::dot(n, toward);
    return facing > 0 && facing * facing > kFacing * kFacing * glm::dot(n, n);
  }
  void approach(std::uint32_t v, float way) {
    if (way >= way_[v] || way >= reach_) return;
    if (way_[v] == kFar) reached_.push_back(v);
    way_[v] = way;
    queue_.emplace(way, v);
  }

  const Facets& facets_;
  const Groups& atVertex_;
  const Charts& charts_;
  float reach_;
  std::vector<float> way_;  // per vertex: from the border, mm
  std::vector<std::uint8_t> isTaken_;
  std::vector<std::uint32_t> reached_;
  std::priority_queue<Step, std::vector<Step>, std::greater<>> queue_;
};

// Per chart the vertices that it shares with a neighbour.
std::vector<std::vector<std::uint32_t>> chartBorders(const Facets& facets, const Charts& charts) {
  std::vector<std::vector<std::uint32_t>> borders(charts.size());
  for (std::uint32_t h = 0; h < facets.opposite.size(); ++h) {
    if (facets.opposite[h] == kNoHalfEdge) continue;
    const std::uint32_t chart = charts.ofTriangle[h / 3];
    if (charts.ofTriangle[facets.opposite[h] / 3] == chart) continue;
    borders[chart].push_back(originOf(facets.mesh.triangles, h));
    borders[chart].push_back(originOf(facets.mesh.triangles, nextHalfEdge(h)));
  }
  return borders;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> chartSkirts(const Facets& facets,
                                                    const std::array<ChartAxis, kChartAxes>& axes,
                                                    const Charts& charts, float reach,
                                                    const Progress& progress) {
  std::vector<std::vector<std::uint32_t>> skirts(charts.size());
  if (!(reach > 0) || charts.size() < 2) return skirts;
  const Groups atVertex = trianglesAtVertices(facets.mesh);
  const std::vector<std::vector<std::uint32_t>> borders = chartBorders(facets, charts);
  std::atomic<std::uint32_t> next{0};
  parallelThreads([&](int, int) {
    SkirtSearch search(facets, atVertex, charts, reach);
    for (std::uint32_t c = next++; c < charts.size(); c = next++)
      skirts[c] = search.search(c, borders[c], axes[charts.axis[c]].toward, progress);
  });
  progress.update(1);
  return skirts;
}

}  // namespace sonoskin
