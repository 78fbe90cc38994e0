#include "core/mesh/search/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"
#include "core/mesh/search/triangle_tree.h"

namespace sonoskin {
namespace {

constexpr std::size_t kVerticesPerTask = 1024;
constexpr float kVisible = 0.5f;

// One measured vertex.
struct Measure {
  float weight = 0;    // area around the vertex, mm²
  float distance = 0;  // mm, negative inside the other surface
  float angle = 0;     // between the normals, degrees
  bool isVisible = true;
};

std::vector<float> vertexAreas(const Mesh& mesh) {
  std::vector<float> areas(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const float third = glm::length(glm::cross(b - a, c - a)) / 6;
    for (const std::uint32_t v : t) areas[v] += third;
  }
  return areas;
}

std::vector<glm::vec3> vertexNormals(const Mesh& mesh) {
  if (!mesh.normals.empty()) return mesh.normals;
  Mesh copy = mesh;
  computeNormals(copy);
  return std::move(copy.normals);
}

template <class T>
T interpolate(const std::vector<T>& values, const Triangle& t, const glm::vec3& w) {
  return w.x * values[t[0]] + w.y * values[t[1]] + w.z * values[t[2]];
}

// The surface that distances are measured to.
struct Target {
  explicit Target(const Mesh& m) : mesh(m), tree(m), normals(vertexNormals(m)) {}
  const Mesh& mesh;
  TriangleTree tree;
  std::vector<glm::vec3> normals;
};

Measure measure(const glm::vec3& p, const glm::vec3& normal, const Target& target, std::uint32_t& guess) {
  const TriangleTree::Hit hit = target.tree.nearest(p, guess);
  guess = hit.triangle;
  const Triangle& t = target.mesh.triangles[hit.triangle];
  const glm::vec3 other = interpolate(target.normals, t, hit.place.weights);
  const float length = glm::length(other), distance = std::sqrt(hit.squaredDistance);
  Measure result;
  result.distance = glm::dot(p - hit.place.position, other) < 0 ? -distance : distance;
  const float cosine = length > 0 ? std::clamp(glm::dot(normal, other) / length, -1.f, 1.f) : 1.f;
  result.angle = glm::degrees(std::acos(cosine));
  if (!target.mesh.visibility.empty())
    result.isVisible = interpolate(target.mesh.visibility, t, hit.place.weights) >= kVisible;
  return result;
}

std::vector<Measure> measureAll(const Mesh& from, const Target& target, const Progress& progress) {
  const std::vector<glm::vec3> normals = vertexNormals(from);
  const std::vector<float> areas = vertexAreas(from);
  std::vector<Measure> result(from.positions.size());
  parallelBlocks(
      result.size(), kVerticesPerTask,
      [&](std::size_t first, std::size_t end) {
        std::uint32_t guess = 0;
        for (std::size_t v = first; v < end; ++v) {
          if (areas[v] == 0) continue;  // no triangle: not part of the surface
          result[v] = measure(from.positions[v], normals[v], target, guess);
          result[v].weight = areas[v];
        }
      },
      progress);
  return result;
}

// The value below which `share` of the weight lies. The pairs are (value, weight), sorted by value.
double weightedQuantile(const std::vector<std::pair<float, float>>& sorted, double total, double share) {
  double sum = 0;
  for (const auto& [value, weight] : sorted) {
    sum += double(weight);
    if (sum >= share * total) return double(value);
  }
  return sorted.empty() ? 0 : double(sorted.back().first);
}

DistanceStatistics summarise(const std::vector<Measure>& measures, bool onlyVisible) {
  DistanceStatistics s;
  std::vector<std::pair<float, float>> absolute, signedValues;
  for (const Measure& m : measures) {
    if (m.weight == 0 || (onlyVisible && !m.isVisible)) continue;
    const double weight = double(m.weight), d = double(m.distance);
    ++s.vertices;
    s.area += weight;
    s.mean += weight * std::abs(d);
    s.rms += weight * d * d;
    s.signedMean += weight * d;
    s.normalAngle += weight * double(m.angle);
    s.max = std::max(s.max, std::abs(d));
    absolute.emplace_back(std::abs(m.distance), m.weight);
    signedValues.emplace_back(m.distance, m.weight);
  }
  if (s.area == 0) return s;
  s.mean /= s.area;
  s.rms = std::sqrt(s.rms / s.area);
  s.signedMean /= s.area;
  s.normalAngle /= s.area;
  std::sort(absolute.begin(), absolute.end());
  std::sort(signedValues.begin(), signedValues.end());
  s.p95 = weightedQuantile(absolute, s.area, 0.95);
  s.signedMedian = weightedQuantile(signedValues, s.area, 0.5);
  return s;
}

}  // namespace

MeshDistances measureDistances(const Mesh& a, const Mesh& b, const Progress& progress) {
  require(!a.empty() && !b.empty(), "A mesh without triangles has no distance to another.");
  MeshDistances result;
  const std::vector<Measure> aToB = measureAll(a, Target(b), progress.part(0, 0.45));
  result.aToB = summarise(aToB, false);
  result.visibleAToB = summarise(aToB, true);
  progress.update(0.5);
  std::vector<Measure> bToA = measureAll(b, Target(a), progress.part(0.5, 0.95));
  for (std::size_t v = 0; v < bToA.size();
       ++v)  // here it is the start that must have been seen, not the target
    bToA[v].isVisible = b.visibility.empty() || b.visibility[v] >= kVisible;
  result.bToA = summarise(bToA, false);
  result.visibleBToA = summarise(bToA, true);
  progress.update(1);
  return result;
}

}  // namespace sonoskin
