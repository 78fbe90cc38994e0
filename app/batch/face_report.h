#pragma once

#include <string>

#include "core/pipeline/face_use.h"

namespace sonoskin {

// FaceReport: what a run says of the face.
//   fit      empty where none was looked for
//   used     whether it was certain enough
struct FaceReport {
  std::optional<FaceFit> fit;
  bool used = false;
  std::string text;
};

FaceReport reportFace(const FaceFit* face, const FaceOptions& options);

// faceJson: {"used", "confidence", "head_height_mm", "up", "front", "landmarks": {name: [x, y, z] in mm}}; of a face
// that is not used the confidence alone.
std::string faceJson(const FaceReport& report);

}  // namespace sonoskin
