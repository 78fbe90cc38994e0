#pragma once

#include <span>

#include "core/face/face_fit.h"
#include "core/volume/scan.h"
#include "render/camera.h"

namespace sonoskin {

// cameraOnFace: an upright camera before a face, as near as shows all of its head that was found.
//   points   of the surface, world mm; not empty
//   face     one that is certain; null: from the probe, all points
//   aspect   width / height of the picture
//   method   From the face's front, but at most 12 degrees from the beams: farther off one looks into what they did not reach.
Camera cameraOnFace(std::span<const glm::vec3> points, const FaceFit* face, const Beam& beam, float aspect);

// isTall: whether what cameraOnFace() shows is taller than wide by more than a tenth.
bool isTall(std::span<const glm::vec3> points, const FaceFit* face, const Beam& beam);

}  // namespace sonoskin
