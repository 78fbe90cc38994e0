#include "core/rbf/surface/iso_surface.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel_blocks.h"
#include "core/mesh/repair/border.h"
#include "core/mesh/repair/clip.h"
#include "core/rbf/compact/csrbf_function.h"
#include "core/rbf/surface/brick_mesher.h"
#include "core/rbf/surface/support_margin.h"

namespace sonoskin {
namespace {

constexpr std::size_t kBricksPerTask = 128;
constexpr float kMarginCells = 6;

// Calls f(brick, first vertex, last vertex) for the bricks that own vertices.
template <class F>
void forEachBrick(const BrickMesh& bricks, const Progress& progress, F&& f) {
  parallelItems(
      bricks.firstVertex.size() - 1, kBricksPerTask,
      [&](std::size_t b) {
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

// Margins: what SupportMargin says of every vertex.
struct Margins {
  std::vector<float> values;
  std::vector<std::uint8_t> isBeyond;
};

Margins marginsOf(const SupportMargin& support, const BrickField& field, const BrickMesh& bricks,
                  const Progress& progress) {
  const std::vector<glm::vec3>&positions = bricks.mesh.positions, &normals = bricks.mesh.normals;
  Margins margins{std::vector<float>(positions.size()), std::vector<std::uint8_t>(positions.size())};
  forEachBrick(bricks, progress, [&](std::size_t b, std::size_t first, std::size_t last) {
    thread_local SupportMargin::Nearby nearby;
    support.gather(field.centre(b), brickReach(field.cell), nearby);
    for (std::size_t v = first; v < last; ++v) {
      const auto place = support.at(positions[v], normals[v], bricks.coverage[v], nearby);
      margins.values[v] = place.value;
      margins.isBeyond[v] = place.isBeyond;
    }
  });
  return margins;
}

// Cuts off what the points do not support, and says how well the rest is.
Mesh cutOff(Mesh mesh, Margins margins, const MeshOptions& options, double spacing,
            const Progress& progress) {
  // The border of points is ragged; their density is smoother than the distance to them.
  const double smoothing = (options.density > 0 ? 2.5 : 5) * spacing;
  const BorderOptions border{SupportMargin::kBand, float(smoothing), float(options.narrowest * spacing),
                             float(options.fillHoles)};
  Border drawn = drawBorder(mesh, std::move(margins.values), margins.isBeyond, border, progress);
  mesh.measured = std::move(drawn.measured);
  if (std::all_of(drawn.keep.begin(), drawn.keep.end(), [](float m) { return m > 0; })) return mesh;
  return clipMesh(mesh, drawn.keep);
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
  const SupportMargin support(points, {float(spacing), gap, float(options.support), float(options.density)});
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
  Margins margins = marginsOf(support, field, bricks, progress.part(0.8, 0.9));
  Mesh mesh = cutOff(std::move(bricks.mesh), std::move(margins), options, spacing, progress.part(0.9, 0.97));
  require(!mesh.empty(),
          "The surface has no part that is supported well enough; lower mesh.density, mesh.narrowest or "
          "mesh.support.");
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
