#pragma once

#include <glm/glm.hpp>

#include "core/phantom/fetal_face.h"
#include "tests/benchmarks/accuracy/faces_score.h"

namespace sonoskin::accuracy {

// FacePose: where a face is and how it is turned. World mm.
//   up, front   unit, across each other: to the crown, and where the nose points
struct FacePose {
  FacePlaces places;
  glm::dvec3 up{0, 1, 0}, front{0, 0, 1};
};

// comparePose: the distances between the landmarks, and the angle of the one turn that takes one head to the other.
//   confidence   that the program has in what it found, 0 to 1
//   output       landmarks, landmarksMax, pose, confidence and misled of `score`
void comparePose(const FacePose& found, const FacePose& truth, double confidence, FaceScore& score);

}  // namespace sonoskin::accuracy
