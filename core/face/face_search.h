#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/face/face_refine.h"
#include "core/face/face_score.h"

namespace sonoskin {

// FaceHypothesis: a face that could be there.
//   score   faceScore, less what an unusual size costs
//   worth   the score times what eyes, nose and mouth say (FaceEvidence::relief squared), and how much it faces the probe: those
//           who record a face have it before them
struct FaceHypothesis {
  FacePlacement face;
  float score = 0;
  FaceEvidence evidence{};
  float worth = 0;
};

// searchFaces: the best faces of all places, turns and sizes, those of most worth first, no two of them alike.
//   toProbe  unit direction toward the probe at the points' middle; faces look within 75 degrees of it
//   method   from all places of the surface 8 mm apart, along the mean normal around each and turned off it, at all
//            rolls and some sizes, by faceScore on 96 points; the best refined, then the best of those again with the
//            modes of shape
//   output   empty where there are too few points
//   cost     0.1 s of one core
//   errors   Cancelled
std::vector<FaceHypothesis> searchFaces(const FaceSpace& space, const glm::vec3& toProbe,
                                        const SizePrior& size, const Progress& progress = {});

}  // namespace sonoskin
