#pragma once

#include <cstdint>

#include "core/volume/volume.h"
#include "render/clip_plane.h"
#include "render/transfer_function.h"

namespace sonoskin {

// ShownPart: what of a volume is there.
//   cropMin, cropMax  0 to 1 along i, j, k
struct ShownPart {
  glm::vec3 cropMin{0}, cropMax{1};
  ClipPlane clip{};

  bool holds(const glm::vec3& index, const Geometry& geometry) const;
  friend bool operator==(const ShownPart&, const ShownPart&) = default;
};

// extinctionVolume: how much light a translucent volume takes away, 1/mm, the mean over cells.
//   coarse    voxels along the side of a cell, >= 1
//   output    its geometry is that of the cells' centres; 0 in cells whose centre is not part of what is shown
//   cost      all voxels once; 467x255x124: about 20 ms of one core
Volume<float> extinctionVolume(const Volume<float>& volume, const TransferFunction& transfer, int coarse,
                               const ShownPart& part = {});
Volume<float> extinctionVolume(const Volume<std::uint8_t>& volume, const TransferFunction& transfer,
                               int coarse, const ShownPart& part = {});

// lightVolume: how much of a far light reaches each cell.
//   toLight   unit, world, toward the light
//   output    0 to 1
//   solves    exp(-integral of the extinction toward the light), plane by plane from where it comes in
//   cost      all cells once; 467x255x124 in cells of 4: about 5 ms of one core
Volume<float> lightVolume(const Volume<float>& extinction, const glm::vec3& toLight);

// extinctionPerMm: of a layer of `opacity` as thick as 1/250 of the diagonal, which is what transfer
// functions mean.
float extinctionPerMm(float opacity, double diagonal);

// worldDiagonal: mm between the centres of the two farthest voxels.
double worldDiagonal(const Geometry& geometry);

}  // namespace sonoskin
