#include "core/mesh/repair/border.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "core/mesh/repair/clip.h"
#include "core/mesh/vertex_rings.h"

namespace sonoskin {
namespace {

double meanEdge(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += double(glm::distance(mesh.positions[t[0]], mesh.positions[t[1]]));
  return sum / double(std::max<std::size_t>(mesh.triangles.size(), 1));
}

// Steps of smoothAlong that spread values over so many mm.
int stepsFor(double mm, double edge) {
  return std::clamp(int(std::lround(2 * mm * mm / (edge * edge))), 2, 200);
}

// Spread: how far some points reach in the directions of a cube's sides and corners; the longest is their size across
// to within a seventh.
class Spread {
 public:
  void add(const glm::vec3& p) {
    for (std::size_t d = 0; d < kDirections.size(); ++d) {
      const float along = glm::dot(kDirections[d], p);
      low_[d] = std::min(low_[d], along);
      high_[d] = std::max(high_[d], along);
    }
  }
  float size() const {
    float most = 0;
    for (std::size_t d = 0; d < kDirections.size(); ++d) most = std::max(most, high_[d] - low_[d]);
    return most;
  }

 private:
  static constexpr float kThird = 0.57735027f;
  static constexpr std::array<glm::vec3, 7> kDirections{glm::vec3(1, 0, 0),
                                                        glm::vec3(0, 1, 0),
                                                        glm::vec3(0, 0, 1),
                                                        glm::vec3(kThird, kThird, kThird),
                                                        glm::vec3(-kThird, kThird, kThird),
                                                        glm::vec3(kThird, -kThird, kThird),
                                                        glm::vec3(kThird, kThird, -kThird)};
  std::array<float, 7> low_ = filled(std::numeric_limits<float>::max()),
                       high_ = filled(std::numeric_limits<float>::lowest());
  static constexpr std::array<float, 7> filled(float v) { return {v, v, v, v, v, v, v}; }
};

// Gaps: the connected parts of a mesh where values are <= 0.
class Gaps {
 public:
  Gaps(const VertexRings& rings, const std::vector<float>& values) : number_(values.size(), kNone) {
    std::vector<std::uint32_t> pending;
    for (std::uint32_t start = 0; start < values.size(); ++start) {
      if (values[start] > 0 || number_[start] != kNone) continue;
      number_[start] = count_;
      pending.push_back(start);
      while (!pending.empty()) {
        const std::uint32_t v = pending.back();
        pending.pop_back();
        for (const std::uint32_t n : rings.of(v)) {
          if (values[n] > 0 || number_[n] != kNone) continue;
          number_[n] = count_;
          pending.push_back(n);
        }
      }
      ++count_;
    }
  }
  std::size_t count() const { return count_; }
  bool has(std::size_t vertex) const { return number_[vertex] != kNone; }
  std::uint32_t of(std::size_t vertex) const { return number_[vertex]; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> number_;
};

// Makes the values positive in gaps that are small and surrounded.
void closeGaps(const Mesh& mesh, const VertexRings& rings, const std::vector<std::uint8_t>& isBeyond,
               const BorderOptions& options, std::vector<float>& values) {
  const Gaps gaps(rings, values);
  std::vector<Spread> spreads(gaps.count());
  std::vector<bool> isOpen(gaps.count(), false);
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!gaps.has(v)) continue;
    spreads[gaps.of(v)].add(mesh.positions[v]);
    if (isBeyond[v]) isOpen[gaps.of(v)] = true;
  }
  for (std::size_t g = 0; g < gaps.count(); ++g) isOpen[g] = isOpen[g] || spreads[g].size() > options.holes;
  for (std::size_t v = 0; v < values.size(); ++v)
    if (gaps.has(v) && !isOpen[gaps.of(v)]) values[v] = options.limit;
}

// Distances along edges from the line where values are 0, on its positive side; 0 elsewhere, `limit` beyond it. [Dijkstra]
std::vector<float> distancesFromZero(const Mesh& mesh, const VertexRings& rings,
                                     const std::vector<float>& values, float limit) {
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<float> distances(values.size(), 0);
  for (std::uint32_t v = 0; v < values.size(); ++v) {
    if (values[v] <= 0) continue;
    distances[v] = limit;
    for (const std::uint32_t n : rings.of(v)) {
      if (values[n] > 0) continue;
      const float share = values[v] / (values[v] - values[n]);
      distances[v] = std::min(distances[v], share * glm::distance(mesh.positions[v], mesh.positions[n]));
    }
    if (distances[v] < limit) queue.emplace(distances[v], v);
  }
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v]) continue;
    for (const std::uint32_t n : rings.of(v)) {
      const float through = distance + glm::distance(mesh.positions[v], mesh.positions[n]);
      if (through >= distances[n]) continue;
      distances[n] = through;
      queue.emplace(through, n);
    }
  }
  return distances;
}

// Values that are negative in narrow parts too.
std::vector<float> opened(const Mesh& mesh, const VertexRings& rings, std::vector<float> values,
                          const BorderOptions& options, float edge) {
  constexpr float kSlack = 1.1f;  // so that a straight border stays where it is
  const float radius = 0.5f * options.narrow;
  std::vector<float> fromBorder = distancesFromZero(mesh, rings, values, 2 * radius);
  for (float& d : fromBorder) d = radius - d;  // > 0 outside of the core
  if (std::all_of(fromBorder.begin(), fromBorder.end(), [](float d) { return d > 0; })) return values;
  const std::vector<float> fromCore = distancesFromZero(mesh, rings, fromBorder, 2 * radius);
  for (std::size_t v = 0; v < values.size(); ++v)
    values[v] = std::min(values[v], (kSlack * radius + 0.5f * edge - fromCore[v]) / radius);
  return values;
}

}  // namespace

Border drawBorder(const Mesh& mesh, std::vector<float> margins, const std::vector<std::uint8_t>& isBeyond,
                  const BorderOptions& options, const Progress& progress) {
  constexpr double kLastSmoothing = 0.6;  // of the first
  Border border{std::move(margins), std::vector<float>(mesh.positions.size(), 1)};
  const auto allKept = [&] {
    return std::all_of(border.keep.begin(), border.keep.end(), [](float v) { return v > 0; });
  };
  const auto isSure = [&](float v) { return v >= options.limit; };
  if (std::all_of(border.keep.begin(), border.keep.end(), isSure)) return border;
  const VertexRings rings(mesh);
  const double edge = meanEdge(mesh), smoothing = double(options.smoothing);
  progress.update(0.1);
  border.keep = smoothAlong(rings, std::move(border.keep), options.limit, stepsFor(smoothing, edge),
                            progress.part(0.1, 0.5));
  for (std::size_t v = 0; v < border.keep.size(); ++v)
    border.measured[v] = std::clamp(border.keep[v] / options.limit, 0.f, 1.f);
  if (options.holes > 0) closeGaps(mesh, rings, isBeyond, options, border.keep);
  progress.update(0.6);
  if (options.narrow <= 0 || allKept()) return border;
  border.keep = opened(mesh, rings, std::move(border.keep), options, float(edge));
  for (float& v : border.keep) v = std::clamp(v, -options.limit, options.limit);
  progress.update(0.8);
  border.keep = smoothAlong(rings, std::move(border.keep), options.limit,
                            stepsFor(kLastSmoothing * smoothing, edge), progress.part(0.8, 1));
  return border;
}

}  // namespace sonoskin
