#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "core/base/hash.h"
#include "core/volume/scan_options.h"
#include "core/volume/volume.h"

namespace sonoskin {

// Beam: how the sound travels through the volume. World mm, LPS.
//   apex   where the beams of a sector meet; without one they are parallel
//   axis   unit direction of the middle beam, away from the probe
//   up     unit direction, across the axis, that is shown upward when one looks along the axis
struct Beam {
  std::optional<glm::dvec3> apex;
  glm::dvec3 axis{0, 1, 0};
  glm::dvec3 up{1, 0, 0};

  // directionAt: unit direction of the beam that passes through `world`.
  glm::dvec3 directionAt(const glm::dvec3& world) const {
    return apex ? glm::normalize(world - *apex) : axis;
  }
};

// Scan: a recorded volume and what is known of it. Holds nothing that identifies a patient.
struct Scan {
  std::shared_ptr<const Volume<float>> volume;  // normalised to [0, 1]
  double originalMin = 0, originalMax = 1;      // what 0 and 1 were in the file
  std::string originalType = "float";           // number type in the file, such as "uint8"
  bool spacingKnown = true;                     // false: the file gave none and 1 mm was assumed
  std::optional<Beam> beam;                     // where the file or the phantom tells
  Key key;                                      // of geometry and voxels
};

// beamOf: the beam that the file tells, else parallel beams from the side that the options name.
Beam beamOf(const Scan& scan, const ScanOptions& options);

// scanKey: the fingerprint of geometry, voxels and beam.
Key scanKey(const Volume<float>& volume, const std::optional<Beam>& beam);

}  // namespace sonoskin
