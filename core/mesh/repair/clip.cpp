#include "core/mesh/repair/clip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace sonoskin {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Clipper: copies what stays and cuts the triangles between.
class Clipper {
 public:
  Clipper(const Mesh& mesh, const std::vector<float>& values)
      : mesh_(mesh), values_(values), number_(mesh.positions.size(), kNone) {}

  Mesh run() {
    numberKept();
    result_.triangles.reserve(mesh_.triangles.size());
    for (const Triangle& t : mesh_.triangles) {
      const int kept = isKept(t[0]) + isKept(t[1]) + isKept(t[2]);
      if (kept == 3) result_.triangles.push_back({number_[t[0]], number_[t[1]], number_[t[2]]});
      if (kept == 1 || kept == 2) cutTriangle(t, kept == 1);
    }
    return std::move(result_);
  }

 private:
  bool isKept(std::uint32_t v) const { return values_[v] > 0; }

  // Copies the vertices that are kept and used, in their order.
  void numberKept() {
    for (const Triangle& t : mesh_.triangles)
      for (const std::uint32_t v : t)
        if (isKept(v)) number_[v] = 0;
    result_.positions.reserve(mesh_.positions.size());
    result_.normals.reserve(mesh_.normals.size());
    for (std::uint32_t v = 0; v < number_.size(); ++v) {
      if (number_[v] == kNone) continue;
      number_[v] = std::uint32_t(result_.positions.size());
      result_.positions.push_back(mesh_.positions[v]);
      if (!mesh_.normals.empty()) result_.normals.push_back(mesh_.normals[v]);
      if (!mesh_.visibility.empty()) result_.visibility.push_back(mesh_.visibility[v]);
      if (!mesh_.labels.empty()) result_.labels.push_back(mesh_.labels[v]);
      if (!mesh_.measured.empty()) result_.measured.push_back(mesh_.measured[v]);
    }
  }

  // The vertex where the edge from a kept vertex to a lost one is cut; the same for both triangles at the edge.
  std::uint32_t cut(std::uint32_t kept, std::uint32_t lost) {
    constexpr float kFromEnds = 0.05f;
    const auto [entry, isNew] = cuts_.try_emplace((std::uint64_t(kept) << 32) | lost, std::uint32_t(0));
    if (!isNew) return entry->second;
    const float t = std::clamp(values_[kept] / (values_[kept] - values_[lost]), kFromEnds, 1 - kFromEnds);
    entry->second = std::uint32_t(result_.positions.size());
    result_.positions.push_back(glm::mix(mesh_.positions[kept], mesh_.positions[lost], t));
    if (!mesh_.normals.empty())
      result_.normals.push_back(glm::normalize(glm::mix(mesh_.normals[kept], mesh_.normals[lost], t)));
    if (!mesh_.visibility.empty())
      result_.visibility.push_back(glm::mix(mesh_.visibility[kept], mesh_.visibility[lost], t));
    if (!mesh_.labels.empty()) result_.labels.push_back(mesh_.labels[kept]);
    if (!mesh_.measured.empty())
      result_.measured.push_back(glm::mix(mesh_.measured[kept], mesh_.measured[lost], t));
    return entry->second;
  }

  void cutTriangle(Triangle t, bool oneIsKept) {
    // Turned so that the first vertex is the one that differs from the other two.
    while (isKept(t[0]) != oneIsKept || isKept(t[1]) == oneIsKept || isKept(t[2]) == oneIsKept)
      t = {t[1], t[2], t[0]};
    if (oneIsKept) {
      const std::uint32_t a = number_[t[0]], b = cut(t[0], t[1]), c = cut(t[0], t[2]);
      result_.triangles.push_back({a, b, c});
      return;
    }
    const std::uint32_t b = number_[t[1]], c = number_[t[2]], ab = cut(t[1], t[0]), ac = cut(t[2], t[0]);
    result_.triangles.push_back({ab, b, c});
    result_.triangles.push_back({ab, c, ac});
  }

  const Mesh& mesh_;
  const std::vector<float>& values_;
  std::vector<std::uint32_t> number_;
  std::unordered_map<std::uint64_t, std::uint32_t> cuts_;
  Mesh result_;
};

}  // namespace

std::vector<float> smoothAlong(const VertexRings& rings, std::vector<float> values, float limit, int steps,
                               const Progress& progress) {
  std::vector<std::uint32_t> moving;
  for (std::uint32_t v = 0; v < values.size(); ++v)
    if (std::abs(values[v]) < limit) moving.push_back(v);
  std::vector<float> smoothed(moving.size());
  for (int step = 0; step < steps; ++step) {
    progress.update(double(step) / double(steps));
    for (std::size_t i = 0; i < moving.size(); ++i) {
      const std::span<const std::uint32_t> ring = rings.of(moving[i]);
      float sum = 0;
      for (const std::uint32_t n : ring) sum += values[n];
      smoothed[i] = 0.5f * (values[moving[i]] + sum / float(std::max<std::size_t>(ring.size(), 1)));
    }
    for (std::size_t i = 0; i < moving.size(); ++i) values[moving[i]] = smoothed[i];
  }
  return values;
}

Mesh clipMesh(const Mesh& mesh, const std::vector<float>& values) { return Clipper(mesh, values).run(); }

}  // namespace sonoskin
