#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/phantom/distance_grid.h"
#include "core/phantom/phantom_model.h"
#include "core/phantom/scene_acoustics.h"
#include "core/phantom/sector_grid.h"

namespace sonoskin {

// Anatomy: the distances that the sound meets, sampled over the field of view. Negative inside.
//   strands   membranes and cord, where there are any
struct Anatomy {
  DistanceGrid skin, bone, wall;
  std::optional<DistanceGrid> strands{};
};

// anatomyGrid: nodes `spacing` mm apart over the field of view and one spacing beyond it, to both sides.
Geometry anatomyGrid(double spacing);

// sampled: one of a model's distances on a grid (see sampleDistance for the band).
//   errors   Cancelled
DistanceGrid sampled(const PhantomModel& model, double (PhantomModel::*distance)(const glm::dvec3&) const,
                     const Geometry& grid, double band, const Progress& progress);

// sampleAnatomy: the phantom's distances on anatomyGrid(spacing), exact where the sound needs them.
//   skinReach  mm before the skin up to which its distance must be right
//   errors     Cancelled
Anatomy sampleAnatomy(const PhantomModel& model, double spacing, float skinReach,
                      const Progress& progress = {});

// echoAmplitude: the root mean square echo of the scatterers at each sample of the sector.
//   model    scattering of each tissue with its texture + a thin reflecting layer at each interface, whose
//            echo falls with the angle between beam and surface as 0.05 + 0.95 cos^3; times what is left of
//            the sound after the way there and back: soft tissue 0.06 to 0.1 dB/mm, bone 9 dB/mm (so it casts
//            a shadow), and skin that the beam grazes 2 dB/mm (the shadow at edges)
//   input    seed: of the particles in the fluid and the patchiness of the skin
//   output   sector.samples(), amplitude; 0.7 is a smooth skin that faces the beam
//   errors   Cancelled
std::vector<float> echoAmplitude(const SectorGrid& sector, const Anatomy& anatomy, int seed,
                                 const SceneAcoustics& acoustics = {}, const Progress& progress = {});

// lossBefore: what the sound loses between the probe and the fluid 1 mm before `world`.
//   output   dB, there and back; infinite where the baby or the cord is in the way, or before the first range
struct TissueDistances {
  const DistanceGrid &skin, &wall;
  const DistanceGrid* strands = nullptr;
};
float lossBefore(const SectorGrid& sector, const TissueDistances& tissues, const glm::vec3& world);

}  // namespace sonoskin
