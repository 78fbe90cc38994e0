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

// LocalBeams: the beams of a volume in the frame of its axes: positions and directions are voxel index .* spacing, mm.
class LocalBeams {
 public:
  LocalBeams(const Beam& beam, const Geometry& geometry);

  // towards: along the beam that passes through `position`, away from the probe; not normalised.
  glm::vec3 towards(const glm::vec3& position) const { return apex_ ? position - *apex_ : axis_; }

 private:
  std::optional<glm::vec3> apex_;
  glm::vec3 axis_;
};

// Scan: a recorded volume and what is known of it. Holds nothing that identifies a patient.
struct Scan {
  std::shared_ptr<const Volume<float>> volume;  // normalised to [0, 1]
  double originalMin = 0, originalMax = 1;      // what 0 and 1 were in the file
  std::string originalType = "float";           // number type in the file, such as "uint8"
  bool spacingKnown = true;                     // false: the file gave none and 1 mm was assumed
  int timeSteps = 1, time = 1;                  // how many its file has, and which of them this is, from 1
  double stepSeconds = 0;                       // from one to the next; 0: the file does not tell
  std::string
      modality{};  // DICOM's word for the machine, such as "US" or "CT"; empty where the file does not tell
  std::optional<Beam> beam;                            // where the file or the phantom tells
  std::shared_ptr<const Volume<std::uint8_t>> mask;    // not zero where something was scanned; may be missing
  Key key;                                             // of geometry and voxels
  std::shared_ptr<const Volume<std::uint8_t>> erased;  // not zero where nothing counts; may be missing
  Key erasedKey;                                       // of what is erased; not part of `key`
};

// beamOf: the beam that the file tells, else one from the side that the options name; its origin as the options say.
//   errors  Error: the options name sides that do not fit
Beam beamOf(const Scan& scan, const ScanOptions& options);

// sidesApart: options that were edited, with probe and top on sides of different axes, which beamOf asks for: where an edit
// put both on one axis, the side that was not edited takes the place that the other one left.
ScanOptions sidesApart(ScanOptions edited, const ScanOptions& before);

// setSpacing: the spacing of a scan whose file gives none; three zeros: it is not known, and 1 mm stands for it.
//   output  other voxels and another key where the spacing is another one
void setSpacing(Scan& scan, const std::array<double, 3>& spacing);
// isSpaced: whether setSpacing() would change nothing.
bool isSpaced(const Scan& scan, const std::array<double, 3>& spacing);

// setMask: takes another volume as the mask of what was scanned: where it is not zero in its file. A mask on another grid,
// such as one with an axis turned over, is looked up where the voxels lie in the world.
//   errors  Error: it lies elsewhere, covers less than half of the volume, or is zero everywhere
void setMask(Scan& scan, const Scan& mask);

// setErased: takes another volume as what was erased by hand: where it is not zero in its file.
//   errors  Error: it lies elsewhere, or is zero everywhere
void setErased(Scan& scan, const Scan& erased);
// The same of a volume on the scan's own grid.
void setErased(Scan& scan, Volume<std::uint8_t> erased);

// maskedKey: the fingerprint of a scan of that key with a mask.
Key maskedKey(const Key& scan, const Volume<std::uint8_t>& mask);

// scanKey: the fingerprint of geometry, voxels and beam.
Key scanKey(const Volume<float>& volume, const std::optional<Beam>& beam);

}  // namespace sonoskin
