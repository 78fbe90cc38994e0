#include "core/rbf/iso_surface.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/rbf/brick_mesher.h"
#include "core/rbf/sample_block.h"

namespace sonoskin {
namespace {

constexpr std::size_t kBricksPerTask = 128;
constexpr float kMarginCells = 6;

// Tests whether any of a set of points is close.
class Closeness {
 public:
  Closeness(const std::vector<glm::vec3>& points, double spacing)
      : spacing_(float(spacing)), grid_(points, float(2.2 * spacing)) {
    for (const std::uint32_t i : grid_.order()) sorted_.push_back(points[i]);
  }
  bool isPointWithin(const glm::vec3& x, float radius) const {
    return radius > 0 && (search(x, std::min(radius, spacing_)) || (radius > spacing_ && search(x, radius)));
  }

 private:
  bool search(const glm::vec3& x, float radius) const {
    bool found = false;
    grid_.forEachRun(x, radius, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last && !found; ++i) {
        const glm::vec3 d = sorted_[i] - x;
        found = glm::dot(d, d) < radius * radius;
      }
    });
    return found;
  }
  float spacing_;
  PointGrid grid_;
  std::vector<glm::vec3> sorted_;
};

// For every brick whether all its vertices are closer than `gap` to a point, so that they need no test of their own.
std::vector<std::uint8_t> findBricksWithinGap(const BrickField& field, const Closeness& closeness, float gap,
                                              const Progress& progress) {
  std::vector<std::uint8_t> within(field.bricks.size());
  const std::size_t tasks = (within.size() + kBricksPerTask - 1) / kBricksPerTask;
  parallelFor(
      std::ptrdiff_t(tasks),
      [&](std::ptrdiff_t task) {
        const std::size_t first = std::size_t(task) * kBricksPerTask;
        for (std::size_t b = first; b < std::min(first + kBricksPerTask, within.size()); ++b)
          within[b] = closeness.isPointWithin(field.centre(b), gap - BrickField::reach(field.cell));
      },
      progress);
  return within;
}

// Unit normals of one brick's vertices: the direction of ∇S, outward because S > 0 outside.
void computeBrickNormals(const CentreIndex& index, const BrickField& field, std::size_t brick,
                         BrickMesh& result) {
  const glm::vec3 anchor = field.centre(brick);
  const float reach = BrickField::reach(field.cell);
  const std::uint32_t last = result.firstVertex[brick + 1];
  for (std::uint32_t first = result.firstVertex[brick]; first < last; first += GradientBlock::kSize) {
    const std::size_t used = std::min<std::size_t>(last - first, GradientBlock::kSize);
    GradientBlock block;
    block.count = (used + 7) / 8 * 8;
    for (std::size_t i = 0; i < used; ++i) {
      const glm::vec3 p = result.mesh.positions[first + i] - anchor;
      block.x[i] = p.x, block.y[i] = p.y, block.z[i] = p.z;
    }
    for (const std::uint32_t n : index.near(anchor)) {
      const Centre& c = index.centres()[n];
      const glm::vec3 d = anchor - c.position;
      const float limit = c.support + reach;
      if (glm::dot(d, d) < limit * limit) addCentre(c, d, block);
    }
    for (std::size_t i = 0; i < used; ++i) {
      const glm::vec3 g(block.gx[i], block.gy[i], block.gz[i]);
      const float length = glm::length(g);
      result.mesh.normals[first + i] = length > 0 ? g / length : glm::vec3(0, 0, 1);
    }
  }
}

void computeModelNormals(const CentreIndex& index, const BrickField& field, BrickMesh& result,
                         const Progress& progress) {
  result.mesh.normals.resize(result.mesh.positions.size());
  const std::size_t bricks = field.bricks.size(), tasks = (bricks + kBricksPerTask - 1) / kBricksPerTask;
  parallelFor(
      std::ptrdiff_t(tasks),
      [&](std::ptrdiff_t task) {
        const std::size_t first = std::size_t(task) * kBricksPerTask;
        for (std::size_t b = first; b < std::min(first + kBricksPerTask, bricks); ++b)
          computeBrickNormals(index, field, b, result);
      },
      progress);
}

void removeUnusedVertices(Mesh& mesh) {
  constexpr std::uint32_t kUnused = 0xffffffffu;
  std::vector<std::uint32_t> number(mesh.positions.size(), kUnused);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) number[v] = 0;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kUnused) continue;
    number[v] = kept;
    mesh.positions[kept] = mesh.positions[v];
    mesh.normals[kept] = mesh.normals[v];
    ++kept;
  }
  mesh.positions.resize(kept);
  mesh.normals.resize(kept);
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
}

float largestSupport(const CsrbfModel& model) {
  float largest = 0;
  for (const Centre& c : model.centres()) largest = std::max(largest, c.support);
  return largest;
}

}  // namespace

Mesh extractIsoSurface(const CsrbfModel& model, const SurfacePoints& points, const MeshOptions& options,
                       const Progress& progress) {
  require(points.size() > 0 && !model.centres().empty(),
          "There are no surface points, so there is no surface.");
  const double spacing = pointSpacing(points.positions);
  const Box box = boundingBox(points.positions);
  const glm::vec3 extent = box.max - box.min;
  const float longest = std::max({extent.x, extent.y, extent.z});
  const float cell = longest / float(options.resolution), gap = float(options.maxGap * spacing);
  require(cell > 0,
          "All surface points lie at one place, which spans no surface; lower the surface threshold.");
  // Lists of centres for cells of 16 nodes, but never so many cells that they cost more than they save.
  const CentreIndex index(model.centres(), std::max(16 * cell, longest / 64), BrickField::reach(cell));
  progress.update(0.05);
  const float margin = std::min(gap, largestSupport(model)) + kMarginCells * cell;
  const BrickField field = sampleBricks(index, points.positions, cell, margin, progress.part(0.05, 0.45));
  const Closeness closeness(points.positions, spacing);
  const std::vector<std::uint8_t> isWithinGap =
      findBricksWithinGap(field, closeness, gap, progress.part(0.45, 0.55));
  const auto keep = [&](std::size_t brick, const glm::vec3& position, float coverage) {
    return double(coverage) > options.support &&
           (isWithinGap[brick] || closeness.isPointWithin(position, gap));
  };
  BrickMesh result = meshBricks(field, keep, progress.part(0.55, 0.75));
  require(!result.mesh.empty(),
          "The surface has no part that is supported well enough; lower the mesh's support.");
  computeModelNormals(index, field, result, progress.part(0.75, 0.95));
  removeUnusedVertices(result.mesh);
  progress.update(1);
  return std::move(result.mesh);
}

}  // namespace sonoskin
