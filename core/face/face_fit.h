#pragma once

#include "core/base/progress.h"
#include "core/face/face_options.h"
#include "core/face/face_placement.h"
#include "core/face/face_score.h"
#include "core/face/face_space.h"

namespace sonoskin {

// FaceFit: where the face is. World mm.
//   confidence   that the face is there, in [0, 1]; 0 where nothing was found, and then the rest means nothing
//   places       eyes (middle of the closed lids), tip of the nose, corners of the mouth, chin; on the surface where one
//                is near; "right" and "left" are the baby's own, or the other way round in a mirrored recording
//   up, front    unit: from the chin to the crown, and where the nose points
//   headHeight   mm from the chin to the crown; the crown is rarely seen: to ten percent
//   rival        score of the best other place beside that of this one
struct FaceFit {
  float confidence = 0;
  HeadPlaces places{};
  glm::vec3 up{0, 1, 0}, front{0, 0, 1};
  float headHeight = 0;
  FacePlacement placement;
  FaceEvidence evidence;
  float score = 0, rival = 0;
};

// fitFace: the family of heads fitted to points and free space.
//   method      searchFaces; of its best, that whose eyes, nose and mouth the surface has too (FaceEvidence::relief).
//               [in the spirit of Alomar 2022, BabyFM; family, evidence and confidence are ours]
//   confidence  a logistic function of relief, explained share, score and rival, fitted to simulated scans of many heads
//               and to surfaces without a face, with its middle where points lie on the skin: a face 0.65 or more, a CT,
//               other ultrasound and wrong places 0.02 or less
//   cost        0.3 s of one core
//   errors      Cancelled
//   threads     the result does not depend on their number
FaceFit fitFace(const FaceInput& input, const FaceOptions& options = {}, const Progress& progress = {});

}  // namespace sonoskin
