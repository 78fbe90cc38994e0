#pragma once

#include "core/face/face_fit.h"
#include "core/mesh/mesh.h"
#include "core/volume/scan.h"
#include "render/pictures.h"

namespace sonoskin {

// pictureFrame: before the face, upright, where one was found; else from the probe.
//   face         one that is certain; null: none
//   size         pixels
//   turnsFormat  a picture of what is taller than wide is upright, of the same size
PictureOptions pictureFrame(const Mesh& mesh, const FaceFit* face, const Beam& beam, glm::ivec2 size,
                            bool turnsFormat);

}  // namespace sonoskin
