#include "core/skin/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace sonoskin {
namespace {

constexpr std::size_t kTrianglesPerTask = 4096;

struct Cut {
  double area = 0;
  std::uint64_t parts = 0;  // along each side; 0: the triangle has no area
};

Cut cutOf(const Mesh& mesh, const Triangle& t, double spacing) {
  const glm::dvec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
  if (!(area > 0)) return {};
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  const double parts = std::ceil(std::max(std::sqrt(area), 0.5 * longest) / spacing);
  return {area, std::uint64_t(std::clamp(parts, 1.0, 65536.0))};
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

// Numbers of each triangle's first sample; one entry more than triangles.
std::vector<std::uint64_t> firstSamples(const Mesh& mesh, double spacing) {
  std::vector<std::uint64_t> first(mesh.triangles.size() + 1, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint64_t parts = cutOf(mesh, mesh.triangles[t], spacing).parts;
    first[t + 1] = first[t] + parts * parts;
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
          const Cut& cut) {
  const Triangle& t = mesh.triangles[triangle];
  const float area = float(cut.area / (double(cut.parts) * double(cut.parts)));
  forEachPart(cut.parts, [&](const glm::vec3& w) {
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
  });
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
  const std::size_t tasks = (mesh.triangles.size() + kTrianglesPerTask - 1) / kTrianglesPerTask;
  parallelFor(
      std::ptrdiff_t(tasks),
      [&](std::ptrdiff_t task) {
        const std::size_t begin = std::size_t(task) * kTrianglesPerTask;
        for (std::size_t t = begin; t < std::min(begin + kTrianglesPerTask, mesh.triangles.size()); ++t)
          fill(samples, std::size_t(first[t]), mesh, std::uint32_t(t),
               cutOf(mesh, mesh.triangles[t], spacing));
      },
      progress);
  return samples;
}

}  // namespace sonoskin
