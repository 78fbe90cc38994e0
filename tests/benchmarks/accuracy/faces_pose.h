#pragma once

#include "tests/benchmarks/accuracy/faces_score.h"

namespace sonoskin::accuracy {

// comparePose: the distances between the landmarks, and the angle of the one turn that takes one head to the other.
//   confidence   that the program has in what it found, 0 to 1
//   output       landmarks, landmarksMax, pose, confidence and misled of `score`
void comparePose(const FacePose& found, const FacePose& truth, double confidence, FaceScore& score);

}  // namespace sonoskin::accuracy
