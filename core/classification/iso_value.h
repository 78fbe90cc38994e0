#pragma once

#include <memory>
#include <vector>

#include "core/volume/field_of_view.h"
#include "core/volume/volume.h"

namespace sonoskin {

// EdgeField: the grey at the steepest edges around a place, known at the middles of equal cells and interpolated between
// them.
//   cells   their number along i, j, k
//   voxels  their size, in voxels
//   grey    one for each cell, i fastest
//   first   the voxel of the whole volume that is (0, 0, 0) here, where this is for a part of it
struct EdgeField {
  glm::ivec3 cells{1};
  glm::vec3 voxels{1};
  std::vector<float> grey;
  glm::ivec3 first{0};

  // row: the grey at the voxels (0 .. count - 1, j, k).
  void row(int j, int k, int count, float* out) const;
};

// GreyLevels: what a volume's greys tell of the skin.
//   fluid  grey of the fluid and the shadows
//   edge   grey at the steepest edges of the whole volume
//   edges  the same from place to place; empty where the volume has none
//   black  share of what is darker than the edge that is as good as black: nearly all where a scanner cut the fluid off
struct GreyLevels {
  float fluid = 0, edge = 0.3f;
  std::shared_ptr<const EdgeField> edges{};
  float black = 0;

  // between: the grey that lies so far on the way from the fluid to the edges, in [0.02, 0.98].
  float between(double share) const;
  // iso: the iso-value of the whole volume. Where the fluid is black a third of `share` is enough: no noise has to be
  // kept out, and faint skin is kept.
  float iso(double share) const;
  // isoRow: the same from place to place, at the voxels (0 .. count - 1, j, k).
  void isoRow(double share, int j, int k, int count, float* out) const;
};

// IsoRange: what an iso-value was found from, for people. Grey, in [0, 1].
//   fluid, edge  of GreyLevels
//   least, most  the smallest and the largest iso-value of any place; the same where one holds everywhere
//   automatic    whether it was found; else it was given
struct IsoRange {
  double fluid = 0, edge = 0, least = 0, most = 0;
  bool automatic = true;
};

// isoRangeOf: of GreyLevels::iso and isoRow.
IsoRange isoRangeOf(const GreyLevels& levels, double share);

// proposeLevels: from the volume.
//   lowPassed  values in [0, 1]
//   view       voxels outside it, and those within 6 voxels of its sides, are not counted
//   beam       edges count that go from dark to bright along it, as skin in fluid does
//   method     edge: the mean grey on the steepest edges, weighted by their gradient [Katz 1965], which does not depend
//              on how much of the volume is fluid; fluid: the mean grey of everything darker than that. From place to
//              place: a surface of thresholds through the grey at edges [Yanowitz and Bruckstein 1989], here a Gaussian
//              mean over kAround mm, weighted by the squared gradient and drawn to the grey of the whole volume where
//              there are few edges; those count that have fluid before them on the beam, so that bone behind the skin
//              does not.
//   cost       looks at 230,000 voxels, evenly spread: 25 ms
GreyLevels proposeLevels(const Volume<float>& lowPassed, const FieldOfView& view, const Beam& beam);

}  // namespace sonoskin
