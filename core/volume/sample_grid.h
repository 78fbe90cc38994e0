#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/volume/scan.h"

// Grids on which 3D probes sample, before scan conversion. Their world is the probe's own frame, mm: nothing anatomical.
namespace sonoskin {

// SweptGrid: a flat picture that was turned about an axis, as probes that wobble do; a torus. Sample i of beam j in picture k
// lies at radius r = firstRadius + i sampleDistance and depth d, and at the sweep's angle p = sweep[k]:
//     fan       x = r sin t,  d = r cos t    t = fan[j], rad from the middle
//     parallel  x = t,        d = r          t = fan[j], mm from the middle
//     y = -(d - axisDepth) sin p,  z = axisDepth + (d - axisDepth) cos p
// so the fan's apex is the origin, the middle beam runs along z, and the axis of the sweep is parallel to x at z = axisDepth.
// Signs as SlicerHeart's reader of Kretz files has them; plooney/kretz has y turned over. Memory order: i, then j, then k.
//   fan, sweep   strictly monotonic, 2 or more; need not be even
struct SweptGrid {
  int samples = 0;  // along a beam
  double firstRadius = 0, sampleDistance = 1, axisDepth = 0;
  std::vector<double> fan, sweep;
  bool parallel = false;

  double lastRadius() const { return firstRadius + sampleDistance * (samples - 1); }
};

// PyramidGrid: straight pictures that draw apart in proportion to the depth. Sample (i, j, k) lies in the middle of cell i of
// `dims.x` across, j of `dims.y` in depth and k of `dims.z` through the stack, which is aperture + growth depth wide.
//   world       x and y are 0 at sample (0, 0, .); z is 0 at the first of the voxels that voxelsOf() gives for no edge
//   lateral, depth   mm between samples of a picture
//   aperture    mm, width of the stack at the near edge of the pictures
//   growth      of the width with the depth: 2 tan of half the opening
struct PyramidGrid {
  glm::ivec3 dims{0};
  double lateral = 1, depth = 1;
  double aperture = 0, growth = 0;

  double widthAt(double y) const { return aperture + growth * (y + 0.5 * depth); }
  double lastWidth() const { return aperture + growth * dims.y * depth; }
  // elevationStep: mm between voxels through the stack: a whole part of the farthest pictures' distance, near to `lateral`.
  double elevationStep() const;
  // middle: z of the middle of the stack.
  double middle() const { return 0.5 * (lastWidth() - elevationStep()); }
};

using SampleGrid = std::variant<SweptGrid, PyramidGrid>;

// gridDims: samples along the three axes of memory, the fastest first.
glm::ivec3 gridDims(const SampleGrid& grid);
// gridName: for people: "fan that was swept".
std::string gridName(const SampleGrid& grid);
// gridFault: why a grid cannot be one, as the end of a sentence; nothing where it can.
std::optional<std::string> gridFault(const SampleGrid& grid);

// gridPlace: where a sample lies, mm; indices need not be whole.
glm::dvec3 gridPlace(const SampleGrid& grid, const glm::dvec3& index);
// gridIndex: the inverse; nothing outside of what was sampled.
std::optional<glm::dvec3> gridIndex(const SampleGrid& grid, const glm::dvec3& place);

// gridBeam: how the sound runs. The beams of a swept fan start at the apex of its middle picture: exact in that picture, and
// within a few degrees beside it, for the axis of the sweep lies nearer to the probe's face. Nothing for a pyramid, whose
// pictures do not tell how they were sampled.
std::optional<Beam> gridBeam(const SampleGrid& grid);

// tableIndex: the place of a value in a strictly monotonic table, in entries; nothing beyond its ends.
std::optional<double> tableIndex(const std::vector<double>& table, double value);

}  // namespace sonoskin
