#pragma once

#include "core/volume/volume.h"
#include "render/transfer_function.h"

namespace sonoskin {

// lightVolume: how much of a far light reaches each place inside a translucent volume.
//   toLight   unit, world, toward the light
//   coarse    voxels along the side of a cell of the result, >= 1
//   output    0 to 1; its geometry is that of the cells' centres
//   solves    exp(-integral of the extinction toward the light), by cells' mean extinction and steps of one
//   cell cost      cells * cells along the longest side; 467x255x124 with coarse = 4: about 60 ms of one core
Volume<float> lightVolume(const Volume<float>& volume, const TransferFunction& transfer,
                          const glm::vec3& toLight, int coarse);

// extinctionPerMm: of a layer of `opacity` as thick as 1/250 of the diagonal, which is what transfer
// functions mean.
float extinctionPerMm(float opacity, double diagonal);

// worldDiagonal: mm between the centres of the two farthest voxels.
double worldDiagonal(const Geometry& geometry);

}  // namespace sonoskin
