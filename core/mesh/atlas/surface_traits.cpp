// Open sky over every vertex, from depth pictures along many directions.
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/parallel_blocks.h"
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

// Occluders: a surface as far as depth pictures tell: vertices that lie in one cell of space are one, at their mean, and
// triangles that are smaller than cells go. What pixels sample of it is as near to the surface as before.
struct Occluders {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

// The cells' numbers in the order of their first vertices.
class CellNumbers {
 public:
  explicit CellNumbers(std::size_t most) : slots_(std::bit_ceil(2 * most + 2), {kFree, 0}) {}
  std::uint32_t number(std::uint64_t cell) {
    const std::size_t last = slots_.size() - 1;
    std::size_t slot = std::size_t((cell * 0x9e3779b97f4a7c15u) >> 32) & last;
    while (slots_[slot].first != kFree && slots_[slot].first != cell) slot = (slot + 1) & last;
    if (slots_[slot].first == kFree) slots_[slot] = {cell, count_++};
    return slots_[slot].second;
  }
  std::uint32_t count() const { return count_; }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t(0);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> slots_;
  std::uint32_t count_ = 0;
};

Occluders clustered(const Mesh& mesh, const glm::vec3& low, float cell) {
  CellNumbers cells(mesh.positions.size());
  std::vector<std::uint32_t> numbers;
  numbers.reserve(mesh.positions.size());
  for (const glm::vec3& p : mesh.positions) {
    const glm::uvec3 c((p - low) / cell);
    numbers.push_back(cells.number((std::uint64_t(c.z) << 42) | (std::uint64_t(c.y) << 21) | c.x));
  }
  std::vector<glm::vec4> sums(cells.count(), glm::vec4(0));
  for (std::size_t i = 0; i < numbers.size(); ++i) sums[numbers[i]] += glm::vec4(mesh.positions[i] - low, 1);
  Occluders result;
  for (const glm::vec4& sum : sums) result.positions.push_back(low + glm::vec3(sum) / sum.w);
  for (const auto& [i, j, k] : mesh.triangles) {
    const Triangle t{numbers[i], numbers[j], numbers[k]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) result.triangles.push_back(t);
  }
  return result;
}

// DepthRange: along one direction the first and last surface behind every pixel.
struct DepthRange {
  glm::vec3 u, v, direction;
  glm::vec3 centre;
  float pixel;  // mm
  std::vector<float> lowest, highest;

  DepthRange(const glm::vec3& toward, const glm::vec3& middle, float pixelLength)
      : direction(toward), centre(middle), pixel(pixelLength) {
    u = perpendicularTo<2, 0>(toward);
    v = glm::cross(toward, u);
  }
  // In pixels, and the depth in mm.
  glm::vec3 project(const glm::vec3& p) const {
    const glm::vec3 away = p - centre;
    return {glm::dot(away, u) / pixel + 0.5f * kPixels, glm::dot(away, v) / pixel + 0.5f * kPixels,
            glm::dot(away, direction)};
  }
  void draw(const Occluders& surface) {
    lowest.assign(kPixels * kPixels, std::numeric_limits<float>::max());
    highest.assign(kPixels * kPixels, -std::numeric_limits<float>::max());
    std::vector<glm::vec3> projected;
    projected.reserve(surface.positions.size());
    for (const glm::vec3& p : surface.positions) projected.push_back(project(p));
    for (const auto& [i, j, k] : surface.triangles) {
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

void addDirection(const glm::vec3& position, const glm::vec3& normal, const DepthRange& range,
                  Openness& openness) {
  const float cosine = glm::dot(normal, range.direction), weight = std::abs(cosine);
  openness.weight += weight;
  if (!range.isOpen(position + range.pixel * normal, cosine > 0)) return;
  openness.openWeight += weight;
  openness.open += cosine * range.direction;
}

std::vector<Openness> openDirections(const Mesh& mesh, const std::vector<glm::vec3>& normals,
                                     const Mesh& occluders, int directions, const Progress& progress) {
  constexpr std::size_t kAtOnce = 16;     // directions whose pictures are in memory
  constexpr std::size_t kPerTask = 2048;  // vertices
  constexpr float kCell = 1.5f;           // pixels
  const Box box = boundingBox(occluders.positions);
  const float pixel = std::max(box.diagonal(), 1e-6f) / float(kPixels - 4);
  const Occluders hiding = clustered(occluders, box.min, kCell * pixel);
  const std::vector<glm::vec3> half = halfSphere(std::max(1, directions / 2));
  std::vector<Openness> openness(mesh.positions.size());
  for (std::size_t first = 0; first < half.size(); first += kAtOnce) {
    const Progress part =
        progress.part(double(first) / double(half.size()), double(first + kAtOnce) / double(half.size()));
    std::vector<DepthRange> ranges;
    for (std::size_t d = first; d < std::min(first + kAtOnce, half.size()); ++d)
      ranges.emplace_back(half[d], box.centre(), pixel);
    parallelFor(
        std::ptrdiff_t(ranges.size()), [&](std::ptrdiff_t d) { ranges[std::size_t(d)].draw(hiding); },
        part.part(0, 0.7));
    parallelItems(
        openness.size(), kPerTask,
        [&](std::size_t i) {
          for (const DepthRange& range : ranges)
            addDirection(mesh.positions[i], normals[i], range, openness[i]);
        },
        part.part(0.7, 1));
  }
  return openness;
}

}  // namespace

SurfaceTraits measureTraits(const Mesh& mesh, int directions, double radius, const Progress& progress) {
  return measureTraits(Facets(mesh), mesh, directions, radius, progress);
}

SurfaceTraits measureTraits(const Facets& facets, const Mesh& occluders, int directions, double radius,
                            const Progress& progress) {
  const Mesh& mesh = facets.mesh;
  SurfaceTraits traits;
  traits.curvature = meanCurvature(facets, radius, progress.part(0, 0.2));
  Mesh withNormals;
  if (mesh.normals.empty()) {
    withNormals = mesh;
    computeNormals(withNormals);
  }
  const std::vector<glm::vec3>& normals = mesh.normals.empty() ? withNormals.normals : mesh.normals;
  const std::vector<Openness> openness =
      openDirections(mesh, normals, occluders, directions, progress.part(0.2, 1));
  traits.occlusion.reserve(openness.size());
  for (std::size_t i = 0; i < openness.size(); ++i) {
    const float length = glm::length(openness[i].open),
                open = openness[i].weight > 0 ? openness[i].openWeight / openness[i].weight : 1;
    traits.occlusion.emplace_back(length > 0 ? openness[i].open / length : normals[i], open);
  }
  return traits;
}

}  // namespace sonoskin
