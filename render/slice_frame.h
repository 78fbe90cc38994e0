#pragma once

#include <glm/glm.hpp>

#include <optional>

#include "core/volume/volume.h"
#include "render/oblique_plane.h"
#include "render/slice_axes.h"

namespace sonoskin {

// SliceCamera: what part of which slice is seen.
//   cursor  world mm; the slice goes through it, and the cross-hair's lines meet there
//   pan     mm that the picture is moved to the right and downward
//   zoom    1: the whole slice just fits
//   planes  how slices lie in the volume
//   oblique the directions of a slice that lies otherwise; `plane` has no meaning then
struct SliceCamera {
  Plane plane = Plane::axial;
  glm::dvec3 cursor{0};
  glm::dvec2 pan{0};
  double zoom = 1;
  PlaneAxes planes{};
  std::optional<PlaneDirections> oblique{};

  const SliceAxes& axes() const { return planes[plane]; }
};

// SliceFrame: from pixels (from the upper left corner; pixel centres at halves) to the world, mm:
// world = corner + x * right + y * down.
struct SliceFrame {
  glm::dvec3 corner{0}, right{1, 0, 0}, down{0, 1, 0};

  glm::dvec3 toWorld(const glm::dvec2& pixel) const { return corner + pixel.x * right + pixel.y * down; }
  // toPixel: where the point's projection onto the slice is seen.
  glm::dvec2 toPixel(const glm::dvec3& world) const;
  double millimetresPerPixel() const { return glm::length(right); }
};

// sliceFrame: the frame of a picture of `size` pixels; the slice of `geometry` is in its middle. An oblique one is as large
// however it lies: zoom 1 has room for the volume's longest side.
SliceFrame sliceFrame(const Geometry& geometry, const SliceCamera& camera, glm::ivec2 size);

}  // namespace sonoskin
