#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/volume/scan.h"

namespace sonoskin {

// Sweep: bounds of a fan that was swept about an axis, as the probes that wobble do: flat in the fan, and so cones in
// space, which no plane can follow. Positions are mm along the axis and away from it.
//   bounds   outward unit normal (along, away), offset at z
struct Sweep {
  glm::vec3 point{0}, direction{1, 0, 0};
  std::vector<glm::vec3> bounds;

  glm::vec2 place(const glm::vec3& position) const {
    const float along = glm::dot(position - point, direction);
    return {along, glm::length(position - point - along * direction)};
  }
  float depth(const glm::vec3& position) const;
};

// FieldOfView: the scanned region: a convex polyhedron, with the cones of swept fans, or a mask. Positions are voxel
// index .* spacing, mm.
//   sides    planes that bound it beside and beyond the anatomy: outward unit normal, offset at w
//   front    planes that look back at the probe: there the hull lies on the anatomy, not on a cut
//   sweeps   at most one for each pair of opposite sides
//   origin   where the sides meet: the origin of the beams; none for parallel sides or where nothing is padded
//   inside   where a mask was given: for every voxel its distance from the mask's border, see maskDepth
struct FieldOfView {
  std::vector<glm::vec4> sides, front;
  std::vector<Sweep> sweeps{};
  std::optional<glm::vec3> origin{};
  std::shared_ptr<const Volume<std::uint8_t>> inside{};

  // depth: mm from the nearest border, positive inside; large where there are none, or beyond the range of a mask.
  float depth(const glm::vec3& position) const;
  bool contains(const glm::vec3& position) const {
    return depth(position) >= 0 && depthBehind(front, position) >= 0;
  }

 private:
  static float depthBehind(const std::vector<glm::vec4>& planes, const glm::vec3& position) {
    float least = 1e30f;
    for (const glm::vec4& p : planes) least = std::min(least, -(glm::dot(glm::vec3(p), position) + p.w));
    return least;
  }
};

// findFieldOfView: where the recording ends.
//   scan     with a mask: the region is the mask. Without: the hull of the voxels that are not zero, for scan converters
//            put zeros outside the sector
//   beam     its axis tells the sides from the front
//   method   the convex hull (qhull) of the first and last voxel of every row; where two opposite sides meet in a line,
//            the outline of the same voxels around that line too. A side leans back from the beams by the sector's
//            opening; a part of the hull that leans back in another way lies on anatomy, and belongs to the front.
//   output   no planes for a volume that is zero or flat
//   cost     60 ms of one core for 467x255x124
//   errors   Cancelled
FieldOfView findFieldOfView(const Scan& scan, const Beam& beam, const Progress& progress = {});
FieldOfView findFieldOfView(const Volume<float>& volume, const Beam& beam, const Progress& progress = {});

// beamWithin: the beam that starts where the sides of the view meet, if it is not known better and the options leave it
// open.
Beam beamWithin(const FieldOfView& view, Beam beam, const Geometry& geometry, const ScanOptions& options);

}  // namespace sonoskin
