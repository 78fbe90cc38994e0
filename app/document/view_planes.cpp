#include "app/document/view_planes.h"

#include "app/texts/texts.h"

namespace sonoskin {

PlanesDecision decidePlanes(const Scan& scan) {
  constexpr double kLeastUltrasound =
      -300;  // values are not negative but in Hounsfield units; as doubtsOf has it
  if (scan.beam) return {false, tr("The scan tells how its beams run: the planes are the scanner's.")};
  if (scan.modality == "US")
    return {false, tr("The scan is ultrasound, which does not know how the patient lies: the planes are the "
                      "scanner's.")};
  if (!scan.modality.empty())
    return {true, tr("The scan knows how the patient lies: the planes are the patient's.")};
  if (scan.originalMin < kLeastUltrasound)
    return {
        true,
        tr("The values are those of a CT, which knows how the patient lies: the planes are the patient's.")};
  return {
      false,
      tr("The file does not tell what made it and is taken for ultrasound: the planes are the scanner's.")};
}

ViewFrame viewFrameOf(const Scan& scan, const Beam& beam, const Orientation& orientation) {
  const bool isPatient = orientation.planes == PlanesChoice::automatic
                             ? decidePlanes(scan).isPatient
                             : orientation.planes == PlanesChoice::patient;
  ViewFrame frame = isPatient ? patientFrame() : scannerFrame(scan.volume->geometry, beam);
  frame.turn = orientation.turn;
  return frame;
}

}  // namespace sonoskin
