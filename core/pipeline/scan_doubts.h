#pragma once

#include <string>
#include <vector>

#include "core/face/face_fit.h"
#include "core/pipeline/scan_evidence.h"
#include "core/volume/scan.h"

namespace sonoskin {

// doubtsOf: why the surface that is made of a scan may not be skin, or its lengths not be true: a sentence each, of what
// is wrong, what follows and what can be done; empty for a scan of skin in fluid.
//   evidence  as in Results
//   face      null where none was looked for; where one was and none is certain, the evidence must be better
//   output    at most one on what was recorded, the most telling one, and one each on sizes
//   method    thresholds between good scans (all scenes of the simulated scan at 8 to 40 dB with heads 0 to 3, and four
//             real ones of a face) and others (noise, CT and MRI, simulated and real; ultrasound of a brain, a heart and
//             bones; simulated liver, spine and abdomen):
//                              good scans     doubt       others, those that it is there for
//               modality       US or none     any other   CT
//               values of 0    0              < -300      CT in Hounsfield units
//               rise / noise   >= 7.8         < 2.5       noise 0.9 to 1.1
//               sideways       <= 0.31        > 0.38      noise 0.49, CT 0.47, MRI 0.46, bone and heart 0.45 to 0.54
//               dark           >= 0.62        < 0.25      brain 0.04, liver 0.02
//               clear          >= 0.74        < 0.62      CT 0.05 to 0.43, MRI 0.40, heart 0.54, brain 0.50
//               width          <= 3.0 mm      > 4.5 mm    a slow ramp 5.4, heart 7.1
//               largest        >= 0.39        < 0.28      spine 0.09, frames of a sweep 0.24
//               size           <= 210 mm      > 350 mm    frames of a sweep 820
//             Without a certain face: sideways > 0.35, dark < 0.45 or clear < 0.68.
std::vector<std::string> doubtsOf(const Scan& scan, const ScanEvidence& evidence, const FaceFit* face,
                                  const FaceOptions& options);

}  // namespace sonoskin
