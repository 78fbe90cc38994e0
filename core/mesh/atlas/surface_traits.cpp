// Open sky over every vertex, from depth pictures along many directions.
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/perpendicular.h"
#include "core/mesh/atlas/atlas_maps.h"
#include "core/mesh/atlas/raster.h"
#include "core/mesh/surface_curvature.h"

namespace sonoskin {
namespace {

constexpr int kPixels = 256;  // along a side of a depth picture

// Fibonacci points on the upper half of a sphere; the lower half is looked to with the same pictures.
std::vector<glm::vec3> halfSphere(int count) {
  const double turn = std::numbers::pi * (3 - std::sqrt(5.));
  std::vector<glm::vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (i + 0.5) / count, r = std::sqrt(1 - z * z);
    directions.emplace_back(r * std::cos(turn * i), r * std::sin(turn * i), z);
  }
  return directions;
}

// DepthRange: along one direction the first and last surface behind every pixel.
struct DepthRange {
  glm::vec3 u, v, direction;
  glm::vec3 centre;
  float pixel;  // mm
  std::vector<float> lowest, highest;

  DepthRange(const glm::vec3& toward, const glm::vec3& middle, float diameter)
      : direction(toward), centre(middle), pixel(diameter / float(kPixels - 4)) {
    u = perpendicularTo<2, 0>(toward);
    v = glm::cross(toward, u);
  }
  // In pixels, and the depth in mm.
  glm::vec3 project(const glm::vec3& p) const {
    const glm::vec3 away = p - centre;
    return {glm::dot(away, u) / pixel + 0.5f * kPixels, glm::dot(away, v) / pixel + 0.5f * kPixels,
            glm::dot(away, direction)};
  }
  void draw(const Mesh& mesh, std::vector<glm::vec3>& projected) {
    lowest.assign(kPixels * kPixels, std::numeric_limits<float>::max());
    highest.assign(kPixels * kPixels, -std::numeric_limits<float>::max());
    projected.resize(mesh.positions.size());
    for (std::size_t i = 0; i < projected.size(); ++i) projected[i] = project(mesh.positions[i]);
    for (const auto& [i, j, k] : mesh.triangles) {
      const glm::vec3 &a = projected[i], &b = projected[j], &c = projected[k];
      forEachTexel({glm::vec2(a), glm::vec2(b), glm::vec2(c)}, kPixels, {0, kPixels},
                   [&](int x, int y, const glm::vec3& w) {
                     const float z = w.x * a.z + w.y * b.z + w.z * c.z;
                     const std::size_t at = std::size_t(y) * kPixels + std::size_t(x);
                     lowest[at] = std::min(lowest[at], z);
                     highest[at] = std::max(highest[at], z);
                   });
    }
  }
  // Whether nothing lies beyond p, along the direction or against it. p is one pixel off its surface, so that the
  // surface itself, sampled up to 0.7 pixels aside, stays below it at any angle.
  bool isOpen(const glm::vec3& p, bool along) const {
    const glm::vec3 at = project(p);
    const int x = int(at.x), y = int(at.y);
    if (x < 0 || y < 0 || x >= kPixels || y >= kPixels) return true;
    const std::size_t i = std::size_t(y) * kPixels + std::size_t(x);
    return along ? highest[i] <= at.z : lowest[i] >= at.z;
  }
};

// Openness: of one vertex; open: the sum of the open directions, each times its cosine.
struct Openness {
  glm::vec3 open{0};
  float openWeight = 0, weight = 0;
};

// Adds what one direction and its opposite show to every vertex.
void addDirection(const Mesh& mesh, const std::vector<glm::vec3>& normals, const DepthRange& range,
                  std::vector<Openness>& openness) {
  for (std::size_t i = 0; i < openness.size(); ++i) {
    const float cosine = glm::dot(normals[i], range.direction), weight = std::abs(cosine);
    openness[i].weight += weight;
    if (!range.isOpen(mesh.positions[i] + range.pixel * normals[i], cosine > 0)) continue;
    openness[i].openWeight += weight;
    openness[i].open += cosine * range.direction;
  }
}

std::vector<Openness> openDirections(const Mesh& mesh, const std::vector<glm::vec3>& normals, int directions,
                                     const Progress& progress) {
  // A fixed number of sums, whatever the number of threads.
  constexpr std::ptrdiff_t kSums = 8;
  const Box box = boundingBox(mesh.positions);
  const std::vector<glm::vec3> half = halfSphere(std::max(1, directions / 2));
  std::vector<std::vector<Openness>> sums(kSums, std::vector<Openness>(mesh.positions.size()));
  parallelFor(
      kSums,
      [&](std::ptrdiff_t s) {
        std::vector<glm::vec3> projected;
        for (std::size_t d = std::size_t(s); d < half.size(); d += kSums) {
          progress.throwIfCancelled();
          DepthRange range(half[d], box.centre(), std::max(box.diagonal(), 1e-6f));
          range.draw(mesh, projected);
          addDirection(mesh, normals, range, sums[std::size_t(s)]);
        }
      },
      progress);
  for (std::size_t s = 1; s < kSums; ++s)
    for (std::size_t i = 0; i < sums[0].size(); ++i) {
      sums[0][i].open += sums[s][i].open;
      sums[0][i].openWeight += sums[s][i].openWeight;
      sums[0][i].weight += sums[s][i].weight;
    }
  return sums[0];
}

}  // namespace

SurfaceTraits measureTraits(const Mesh& mesh, int directions, double radius, const Progress& progress) {
  SurfaceTraits traits;
  traits.curvature = meanCurvature(mesh, radius, progress.part(0, 0.2));
  Mesh withNormals;
  if (mesh.normals.empty()) {
    withNormals = mesh;
    computeNormals(withNormals);
  }
  const std::vector<glm::vec3>& normals = mesh.normals.empty() ? withNormals.normals : mesh.normals;
  const std::vector<Openness> openness = openDirections(mesh, normals, directions, progress.part(0.2, 1));
  for (std::size_t i = 0; i < openness.size(); ++i) {
    const float length = glm::length(openness[i].open),
                open = openness[i].weight > 0 ? openness[i].openWeight / openness[i].weight : 1;
    traits.occlusion.emplace_back(length > 0 ? openness[i].open / length : normals[i], open);
  }
  return traits;
}

}  // namespace sonoskin
