#include "core/mesh/print/print_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/perpendicular.h"
#include "core/mesh/components.h"
#include "core/mesh/facts/mesh_check.h"
#include "core/mesh/iso/marching_cubes.h"
#include "core/mesh/print/relief.h"
#include "core/mesh/print/wall_field.h"
#include "core/mesh/repair/fill_holes.h"

namespace sonoskin {
namespace {

constexpr double kMostCells = 400, kLeastCells = 100;  // along the longest side
constexpr double kMostNodes = 1.2e8;
constexpr double kCellsPerWall = 4, kLeastCellsPerWall = 2.5;
constexpr int kLargestBlock = 16, kCornersTell = 8, kSmallestBlock = 4;  // nodes along a side
// Values stay this far from zero and below this, in cells: no triangle shrinks to nothing, and where the function
// jumps the surface lies between the nodes.
constexpr float kLeastValue = 0.02f, kLargestValue = 3;
constexpr double kSmallPiece = 0.01;

// The surface alone, with its holes closed.
Mesh closedAtHoles(const Mesh& surface, const Progress& progress) {
  Mesh plain;
  plain.positions = surface.positions;
  plain.triangles = surface.triangles;
  return fillHoles(plain, {std::numeric_limits<double>::infinity(), Outline::keep}, progress);
}

// Against the mean of the normals: away from whoever looks at the surface.
glm::dvec3 awayFrom(const Mesh& surface) {
  glm::dvec3 sum(0);
  for (const auto& [a, b, c] : surface.triangles)
    sum -= glm::cross(glm::dvec3(surface.positions[b] - surface.positions[a]),
                      glm::dvec3(surface.positions[c] - surface.positions[a]));
  const double length = glm::length(sum);
  return length > 1e-6 * surfaceArea(surface) ? sum / length : glm::dvec3(0, 1, 0);
}

glm::dmat3 frameAlong(const glm::dvec3& axis) {
  const glm::dvec3 right = perpendicularTo<0, 1>(axis);
  return {right, glm::cross(axis, right), axis};
}

double meanSide(const Mesh& surface) {
  double sum = 0;
  for (const Triangle& t : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sum += double(glm::distance(surface.positions[t[i]], surface.positions[t[(i + 1) % 3]]));
  return sum / (3 * double(surface.triangles.size()));
}

// As fine as the surface's triangles, within reason.
double cellFor(const Mesh& surface, const glm::dvec3& size, double thickness) {
  const double longest = std::max({size.x, size.y, size.z});
  double cell = std::clamp(meanSide(surface), longest / kMostCells, longest / kLeastCells);
  cell =
      std::max(std::min(cell, thickness / kCellsPerWall), std::cbrt(size.x * size.y * size.z / kMostNodes));
  require(
      thickness >= kLeastCellsPerWall * cell,
      "A wall of {:.2f} mm is too thin for a surface of this size: print.thickness must be {:.2f} or more.",
      thickness, kLeastCellsPerWall * cell);
  return cell;
}

// A grid of cubic cells around the surface and the wall behind it; its third axis leads away.
Geometry gridAround(const Mesh& surface, double thickness) {
  Geometry grid;
  grid.direction = frameAlong(awayFrom(surface));
  const glm::dmat3 toFrame = glm::transpose(grid.direction);
  glm::dvec3 low(1e30), high(-1e30);
  for (const glm::vec3& p : surface.positions) {
    low = glm::min(low, toFrame * glm::dvec3(p));
    high = glm::max(high, toFrame * glm::dvec3(p));
  }
  const double cell = cellFor(surface, high - low + 2 * thickness, thickness), margin = thickness + 3 * cell;
  grid.spacing = glm::dvec3(cell);
  grid.origin = grid.direction * (low - margin);
  grid.dims = glm::ivec3(glm::ceil((high - low + 2 * margin) / cell)) + 1;
  return grid;
}

// Solid: the function whose negative side is printed, at the nodes of a grid.
class Solid {
 public:
  Solid(const Mesh& surface, const PrintOptions& options, const Geometry& grid, const Progress& progress)
      : grid_(grid),
        cell_(float(grid.spacing.x)),
        thickness_(float(options.thickness)),
        wall_(surface, thickness_, cell_) {
    if (options.form != PrintForm::block) return;
    relief_ = makeRelief(surface, grid, 0.5f * thickness_, progress);
    for (const glm::vec3& p : surface.positions)
      plane_ = std::max(plane_, float(grid.toIndex(glm::dvec3(p)).z) * cell_ + thickness_);
  }

  // fillBlock: the nodes from `first` on, as far as the block and the grid go; where the wall's border may be near, in
  // smaller and smaller blocks.
  void fillBlock(const glm::ivec3& first, int size, std::uint32_t guess, Volume<float>& field) const {
    const glm::ivec3 end = glm::min(first + size, grid_.dims);
    if (glm::any(glm::lessThanEqual(end, first))) return;
    const Wall wall = wallIn(first, end, guess);
    if (wall.known != Wall::Known::nothing || size <= kSmallestBlock)
      return fillNodes(first, end, wall, field);
    for (int octant = 0; octant < 8; ++octant)
      fillBlock(first + size / 2 * glm::ivec3(octant & 1, octant >> 1 & 1, octant >> 2), size / 2,
                wall.triangle, field);
  }

 private:
  // What is known of the wall in a whole block.
  struct Wall {
    enum class Known { outside, inside, nothing } known = Known::nothing;
    std::uint32_t triangle = 0;
  };

  glm::vec3 worldAt(const glm::dvec3& node) const { return glm::vec3(grid_.toWorld(node)); }

  void fillNodes(const glm::ivec3& first, const glm::ivec3& end, const Wall& wall,
                 Volume<float>& field) const {
    std::uint32_t guess = wall.triangle;
    for (int k = first.z; k < end.z; ++k)
      for (int j = first.y; j < end.y; ++j)
        for (int i = first.x; i < end.x; ++i) {
          const float value = valueAt({i, j, k}, wall, guess) / cell_;
          const float size = std::clamp(std::abs(value), kLeastValue, kLargestValue);
          field.at(i, j, k) = value < 0 ? -size : size;
        }
  }

  // Where the wall's border is surely farther than the block is large. That is known from the middle; but beside
  // another sheet of the surface the function may jump, so small blocks ask their corners too.
  Wall wallIn(const glm::ivec3& first, const glm::ivec3& end, std::uint32_t guess) const {
    const glm::dvec3 low(first), high(end - 1);
    const WallField::Value middle = wall_.at(worldAt(0.5 * (low + high)), guess);
    const float reach = 0.5f * cell_ * float(glm::length(high - low)) + 2 * cell_;
    if (middle.distance > thickness_ + reach) return {Wall::Known::outside, middle.triangle};
    const bool isSmall = end.z - first.z <= kCornersTell;
    bool isSure = isSmall && std::abs(middle.field) > reach && middle.distance > reach;
    for (int corner = 0; corner < 8 && isSure; ++corner) {
      const glm::dvec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
      const WallField::Value at = wall_.at(worldAt(glm::mix(low, high, side)), middle.triangle);
      isSure = (at.field < 0) == (middle.field < 0);
    }
    if (!isSure) return {Wall::Known::nothing, middle.triangle};
    return {middle.field < 0 ? Wall::Known::inside : Wall::Known::outside, middle.triangle};
  }

  float valueAt(const glm::ivec3& node, const Wall& wall, std::uint32_t& guess) const {
    const float far = kLargestValue * cell_, along = float(node.z) * cell_;
    const float behind = relief_ ? relief_->field(node.x, node.y, along) : far;
    float value = behind;
    if (wall.known == Wall::Known::inside) value = -far;
    if (wall.known == Wall::Known::nothing && behind > -1.5f * cell_) {
      const WallField::Value at = wall_.at(worldAt(glm::dvec3(node)), guess);
      guess = at.triangle;
      value = std::min(value, at.field);
    }
    return relief_ ? std::max(value, along - plane_) : value;
  }

  const Geometry& grid_;
  float cell_, thickness_;
  WallField wall_;
  std::optional<Relief> relief_;
  float plane_ = 0;  // where a block ends, mm along the third axis
};

Volume<float> sample(const Solid& solid, const Geometry& grid, const Progress& progress) {
  auto field = Volume<float>::unset(grid);
  const glm::ivec3 blocks = (grid.dims + kLargestBlock - 1) / kLargestBlock;
  parallelFor(
      std::ptrdiff_t(blocks.x) * blocks.y * blocks.z,
      [&](std::ptrdiff_t block) {
        const glm::ivec3 at(block % blocks.x, block / blocks.x % blocks.y, block / blocks.x / blocks.y);
        solid.fillBlock(kLargestBlock * at, kLargestBlock, 0, field);
      },
      progress);
  return field;
}

// The outer sides of what is large enough: no bubbles inside, no crumbs.
Mesh withoutBubbles(const Mesh& mesh, const Progress& progress) {
  std::vector<Mesh> pieces = splitPieces(mesh, progress);
  double largest = 0;
  for (const Mesh& piece : pieces) largest = std::max(largest, enclosedVolume(piece));
  std::erase_if(pieces, [&](const Mesh& piece) { return enclosedVolume(piece) < kSmallPiece * largest; });
  return joinPieces(pieces);
}

}  // namespace

Mesh makePrintSolid(const Mesh& surface, const PrintOptions& options, const Progress& progress) {
  require(options.form != PrintForm::none, "Nothing is to be printed: set print.form to shell or block.");
  require(!surface.empty(), "There is no surface to print.");
  const Mesh whole = closedAtHoles(surface, progress.part(0, 0.2));
  const Geometry grid = gridAround(whole, options.thickness);
  const Solid solid(whole, options, grid, progress.part(0.2, 0.25));
  Mesh mesh;
  {
    const Volume<float> field = sample(solid, grid, progress.part(0.25, 0.8));
    mesh = marchingCubes(field, 0, progress.part(0.8, 0.9));
  }
  mesh = withoutBubbles(mesh, progress.part(0.9, 0.95));
  require(!mesh.empty(), "The surface is too small to be printed with a wall of {:.2f} mm.",
          options.thickness);
  for (glm::vec3& p : mesh.positions) p *= float(options.scale);
  computeNormals(mesh);
  progress.update(1);
  return mesh;
}

}  // namespace sonoskin
