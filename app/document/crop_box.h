#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/surface/region_options.h"
#include "core/volume/volume.h"

namespace sonoskin {

// Side: one face of the crop box: the low or the high one across an axis i, j, k.
struct Side {
  int axis = 0;
  bool high = false;
};

// sideAt: where a side lies, mm along its axis from the centre of the first voxel: 0 and the volume's length where
// nothing is cut.
double sideAt(const Side& side, const RegionOptions& options, const Geometry& geometry);

// moveSide: moves a side to a place along its axis, to a tenth of a millimetre; it stays in the volume, and a
// millimetre or a voxel of the box is left.
void moveSide(const Side& side, double mm, RegionOptions& options, const Geometry& geometry);

// boxCorners: the box in the world: its lowest and its highest corner along i, j, k, half a voxel beyond the centres of
// its outermost voxels.
std::array<glm::dvec3, 2> boxCorners(const RegionOptions& options, const Geometry& geometry);

// boxIn: the sides of the box as voxel indices of a volume that covers the same part of the world, such as a coarser one.
std::array<glm::dvec3, 2> boxIn(const Geometry& other, const RegionOptions& options,
                                const Geometry& geometry);

// Grip: which edges of a rectangle a mouse holds: -1 the left or upper one, 1 the right or lower one, 0 none.
struct Grip {
  int right = 0, down = 0;
  explicit operator bool() const { return right != 0 || down != 0; }
};

// gripAt: the edges within `reach` of the mouse, all in pixels; the nearer one of two opposite ones.
Grip gripAt(const glm::dvec2& upperLeft, const glm::dvec2& lowerRight, const glm::dvec2& mouse, double reach);

}  // namespace sonoskin
