#include "core/skin/surface_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"

namespace sonoskin {
namespace {

constexpr std::size_t kTrianglesPerTask = 4096;
// A triangle of so many parts along its sides whose shortest side is below so many spacings is a sliver.
constexpr double kSliverParts = 16, kSliverWidth = 0.5;

struct Subdivision {
  double area = 0;
  std::uint64_t parts = 0;  // along each side; 0: the triangle has no area
  int tip = -1;             // of a sliver: the corner from which its strips are counted

  std::uint64_t count() const { return tip >= 0 ? parts : parts * parts; }
};

Subdivision subdivide(const Mesh& mesh, const Triangle& t, double spacing) {
  const glm::dvec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
  if (!(area > 0)) return {};
  const std::array<double, 3> across{glm::distance(b, c), glm::distance(c, a), glm::distance(a, b)};
  const auto [shortest, longest] = std::ranges::minmax_element(across);
  const double parts = std::ceil(std::max(std::sqrt(area), 0.5 * *longest) / spacing);
  const bool isSliver = parts >= kSliverParts && *shortest < kSliverWidth * spacing;
  return {area, std::uint64_t(std::clamp(parts, 1.0, 65536.0)),
          isSliver ? int(shortest - across.begin()) : -1};
}

// Calls f(weights of the corners) for the middles of n * n equal parts of a triangle.
template <class F>
void forEachPart(std::uint64_t n, F&& f) {
  const double step = 1 / double(n);
  for (std::uint64_t u = 0; u < n; ++u)
    for (std::uint64_t v = 0; u + v < n; ++v)
      for (const double middle : {1.0 / 3, 2.0 / 3}) {  // the part itself and the one that stands on its head
        if (middle > 0.5 && u + v + 1 == n) continue;
        const double b = (double(u) + middle) * step, c = (double(v) + middle) * step;
        f(glm::vec3(float(1 - b - c), float(b), float(c)));
      }
}

// Calls f(weights of the corners, share of the area) for the middles of n strips of equal length across a sliver.
template <class F>
void forEachStrip(std::uint64_t n, int tip, F&& f) {
  for (std::uint64_t i = 0; i < n; ++i) {
    const double from = double(i) / double(n), to = double(i + 1) / double(n);
    const double share = to * to - from * from,
                 middle = 2.0 / 3 * (to * to * to - from * from * from) / share;
    glm::vec3 weights(float(0.5 * middle));
    weights[tip] = float(1 - middle);
    f(weights, share);
  }
}

// Numbers of each triangle's first sample; one entry more than triangles.
std::vector<std::uint64_t> firstSamples(const Mesh& mesh, double spacing) {
  std::vector<std::uint64_t> first(mesh.triangles.size() + 1, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    first[t + 1] = first[t] + subdivide(mesh, mesh.triangles[t], spacing).count();
    require(first[t + 1] < std::uint64_t(std::numeric_limits<std::int32_t>::max()),
            "A surface of this size cannot be sampled every {} mm.", spacing);
  }
  return first;
}

void resize(SurfaceSamples& samples, std::size_t count) {
  samples.positions.resize(count);
  samples.normals.resize(count);
  samples.areas.resize(count);
  samples.triangles.resize(count);
  samples.weights.resize(count);
}

void fill(SurfaceSamples& samples, std::size_t first, const Mesh& mesh, std::uint32_t triangle,
          const Subdivision& cut) {
  const Triangle& t = mesh.triangles[triangle];
  const auto add = [&](const glm::vec3& w, float area) {
    const auto mix = [&](const std::vector<glm::vec3>& of) {
      return w.x * of[t[0]] + w.y * of[t[1]] + w.z * of[t[2]];
    };
    const glm::vec3 normal = mix(mesh.normals);
    const float length = glm::length(normal);
    samples.positions[first] = mix(mesh.positions);
    samples.normals[first] = length > 0 ? normal / length : mesh.normals[t[0]];
    samples.areas[first] = area;
    samples.triangles[first] = triangle;
    samples.weights[first] = w;
    ++first;
  };
  if (cut.tip >= 0) {
    forEachStrip(cut.parts, cut.tip,
                 [&](const glm::vec3& w, double share) { add(w, float(share * cut.area)); });
    return;
  }
  const float area = float(cut.area / (double(cut.parts) * double(cut.parts)));
  forEachPart(cut.parts, [&](const glm::vec3& w) { add(w, area); });
}

}  // namespace

SurfaceSamples sampleSurface(const Mesh& mesh, double spacing, const Progress& progress) {
  require(!mesh.empty(), "A mesh without triangles has no surface to sample.");
  require(spacing > 0, "Samples need a spacing above 0 mm.");
  if (mesh.normals.empty()) {
    Mesh copy = mesh;
    computeNormals(copy);
    return sampleSurface(copy, spacing, progress);
  }
  const std::vector<std::uint64_t> first = firstSamples(mesh, spacing);
  SurfaceSamples samples;
  samples.spacing = float(spacing);
  resize(samples, std::size_t(first.back()));
  parallelItems(
      mesh.triangles.size(), kTrianglesPerTask,
      [&](std::size_t t) {
        fill(samples, std::size_t(first[t]), mesh, std::uint32_t(t),
             subdivide(mesh, mesh.triangles[t], spacing));
      },
      progress);
  return samples;
}

double affordableSpacing(const Mesh& mesh, double spacing, std::size_t most) {
  constexpr double kWider = 1.15;
  for (;; spacing *= kWider) {
    std::uint64_t count = 0, cut = 0;
    for (const Triangle& t : mesh.triangles) {
      const std::uint64_t parts = subdivide(mesh, t, spacing).count();
      count += parts;
      cut += parts > 1;
    }
    if (count <= most || cut == 0) return spacing;
  }
}

}  // namespace sonoskin
