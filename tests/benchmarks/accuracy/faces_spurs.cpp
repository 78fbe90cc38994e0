#include "tests/benchmarks/accuracy/faces_spurs.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/mesh/components.h"

namespace sonoskin::accuracy {
namespace {

constexpr float kNoTruth = 1.5f, kStandsOff = 2;  // mm
constexpr std::ptrdiff_t kBatch = 1024;

std::vector<float> vertexDistances(const Mesh& mesh, const FaceTruth& truth) {
  std::vector<float> distances(mesh.positions.size());
  const auto count = std::ptrdiff_t(distances.size());
  parallelFor((count + kBatch - 1) / kBatch, [&](std::ptrdiff_t batch) {
    for (std::ptrdiff_t v = batch * kBatch; v < std::min(count, (batch + 1) * kBatch); ++v)
      distances[std::size_t(v)] = truth.distanceUpTo(mesh.positions[std::size_t(v)], kStandsOff);
  });
  return distances;
}

}  // namespace

Spurs findSpurs(const Mesh& mesh, const FaceTruth& truth) {
  const std::vector<float> distances = vertexDistances(mesh, truth);
  Mesh off;
  off.positions = mesh.positions;
  for (const Triangle& t : mesh.triangles)
    if (std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return distances[v] > kNoTruth; }))
      off.triangles.push_back(t);
  const std::vector<std::uint32_t> piece = pieceOfVertices(off);
  std::vector<char> standsOff;
  for (std::size_t v = 0; v < piece.size(); ++v) {
    if (piece[v] == 0xffffffffu) continue;
    if (piece[v] >= standsOff.size()) standsOff.resize(piece[v] + 1, 0);
    if (distances[v] >= kStandsOff) standsOff[piece[v]] = 1;
  }
  Spurs spurs;
  spurs.count = std::size_t(std::count(standsOff.begin(), standsOff.end(), 1));
  const auto first = std::find(standsOff.begin(), standsOff.end(), 1) - standsOff.begin();  // the largest
  glm::dvec3 moment(0);
  double weight = 0;
  for (const Triangle& t : off.triangles) {
    if (!standsOff[piece[t[0]]]) continue;
    const glm::dvec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    spurs.area += area;
    if (std::ptrdiff_t(piece[t[0]]) == first) moment += area / 3 * (a + b + c), weight += area;
  }
  if (weight > 0) spurs.largest = glm::vec3(moment / weight);
  return spurs;
}

}  // namespace sonoskin::accuracy
