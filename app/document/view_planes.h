#pragma once

#include <array>

#include "core/volume/scan.h"
#include "render/slice_axes.h"

namespace sonoskin {

// PlanesChoice: whose planes slices are: what is known of the scan decides, or a person.
enum class PlanesChoice { automatic, patient, scanner };
constexpr std::array<const char*, 3> enumNames(PlanesChoice) { return {"automatic", "patient", "scanner"}; }

// PlanesDecision: whose planes a scan is shown in, and why, in a sentence for people.
struct PlanesDecision {
  bool isPatient = false;
  const char* reason = "";
};

// decidePlanes: of a scan alone. Directions of the patient mean something where the machine knew how the patient lay: CT, MR
// and others, but not ultrasound, whose files fill them in for form's sake.
PlanesDecision decidePlanes(const Scan& scan);

// Orientation: what a person has chosen for a document.
//   planes  whose they are
//   turn    see ViewFrame
struct Orientation {
  PlanesChoice planes = PlanesChoice::automatic;
  glm::dmat3 turn{1};
};

// viewFrameOf: the frame of slices and 3D view.
//   beam  beamOf() the scan
ViewFrame viewFrameOf(const Scan& scan, const Beam& beam, const Orientation& orientation = {});

}  // namespace sonoskin
