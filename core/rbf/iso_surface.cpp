#include "core/rbf/iso_surface.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/clip.h"
#include "core/rbf/brick_mesher.h"
#include "core/rbf/csrbf_function.h"
#include "core/rbf/support_margin.h"

namespace sonoskin {
namespace {

constexpr std::size_t kBricksPerTask = 128;
constexpr float kMarginCells = 6;

// Calls f(brick, first vertex, last vertex) for the bricks that own vertices.
template <class F>
void forEachBrick(const BrickMesh& bricks, const Progress& progress, F&& f) {
  const std::size_t count = bricks.firstVertex.size() - 1;
  parallelFor(
      std::ptrdiff_t((count + kBricksPerTask - 1) / kBricksPerTask),
      [&](std::ptrdiff_t task) {
        const std::size_t first = std::size_t(task) * kBricksPerTask;
        for (std::size_t b = first; b < std::min(first + kBricksPerTask, count); ++b)
          if (bricks.firstVertex[b] < bricks.firstVertex[b + 1])
            f(b, bricks.firstVertex[b], bricks.firstVertex[b + 1]);
      },
      progress);
}

// Unit normals: the direction of ∇S, outward because S > 0 outside.
void computeModelNormals(const ImplicitFunction& function, const BrickField& field, BrickMesh& bricks,
                         const Progress& progress) {
  Mesh& mesh = bricks.mesh;
  mesh.normals.resize(mesh.positions.size());
  forEachBrick(bricks, progress, [&](std::size_t b, std::size_t first, std::size_t last) {
    function.gradients(field.centre(b), std::span(mesh.positions).subspan(first, last - first),
                       &mesh.normals[first]);
    for (std::size_t v = first; v < last; ++v) {
      const float length = glm::length(mesh.normals[v]);
      mesh.normals[v] = length > 0 ? mesh.normals[v] / length : glm::vec3(0, 0, 1);
    }
  });
}

std::vector<float> marginsOf(const SupportMargin& support, const BrickMesh& bricks,
                             const Progress& progress) {
  std::vector<float> margins(bricks.mesh.positions.size());
  forEachBrick(bricks, progress, [&](std::size_t, std::size_t first, std::size_t last) {
    SupportMargin::Hint hint;
    for (std::size_t v = first; v < last; ++v)
      margins[v] = support.at(bricks.mesh.positions[v], bricks.coverage[v], hint);
  });
  return margins;
}

// Cuts off what the points do not support. The border of points is ragged; smoothed over a few spacings it is not.
Mesh cutOff(Mesh mesh, std::vector<float> margins, double spacing, float cell, const Progress& progress) {
  constexpr double kSmoothedOver = 5;  // spacings
  if (std::all_of(margins.begin(), margins.end(), [](float m) { return m > 0; })) return mesh;
  const double edges = kSmoothedOver * spacing / double(cell);
  const int steps = std::clamp(int(2 * edges * edges), 2, 200);
  margins = smoothAlong(mesh, std::move(margins), SupportMargin::kBand, steps, progress);
  progress.update(1);
  return clipMesh(mesh, margins);
}

}  // namespace

float meshCell(const std::vector<glm::vec3>& points, const MeshOptions& options) {
  const Box box = boundingBox(points);
  const glm::vec3 extent = box.max - box.min;
  const float longest = std::max({extent.x, extent.y, extent.z});
  require(longest > 0,
          "All surface points lie at one place, which spans no surface; lower the surface threshold.");
  if (options.cell <= 0) return longest / float(options.resolution);
  constexpr double kMostCells = 4000;
  require(double(longest) / options.cell <= kMostCells,
          "mesh.cell is {} mm, but the surface is {:.0f} mm long: more than {:.0f} cells along one side take "
          "too much "
          "memory; choose at least {:.2f} mm.",
          options.cell, longest, kMostCells, double(longest) / kMostCells);
  return float(options.cell);
}

Mesh extractIsoSurface(const ImplicitFunction& function, const SurfacePoints& points,
                       const MeshOptions& options, const Progress& progress) {
  const double spacing = pointSpacing(points.positions);
  const auto gap = float(options.maxGap * spacing);
  const SupportMargin support(points.positions, float(spacing), gap, float(options.support));
  progress.update(0.05);
  const float around =
      std::min((1 + SupportMargin::kBand) * gap, function.reach) + kMarginCells * function.cell;
  const auto wanted = [&](const glm::vec3& centre) {
    return support.mayStay(centre, brickReach(function.cell));
  };
  const BrickField field =
      sampleBricks(function, points.positions, around, wanted, progress.part(0.05, 0.45));
  BrickMesh bricks = meshBricks(field, progress.part(0.45, 0.65));
  computeModelNormals(function, field, bricks, progress.part(0.65, 0.8));
  std::vector<float> margins = marginsOf(support, bricks, progress.part(0.8, 0.9));
  Mesh mesh =
      cutOff(std::move(bricks.mesh), std::move(margins), spacing, function.cell, progress.part(0.9, 0.97));
  require(!mesh.empty(), "The surface has no part that is supported well enough; lower the mesh's support.");
  progress.update(1);
  return mesh;
}

Mesh extractIsoSurface(const CsrbfModel& model, const SurfacePoints& points, const MeshOptions& options,
                       const Progress& progress) {
  require(points.size() > 0 && !model.centres().empty(),
          "There are no surface points, so there is no surface.");
  const ImplicitFunction function = csrbfFunction(model, meshCell(points.positions, options));
  return extractIsoSurface(function, points, options, progress);
}

}  // namespace sonoskin
