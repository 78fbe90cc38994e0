#pragma once

#include "core/face/face_placement.h"
#include "core/face/face_space.h"

namespace sonoskin {

// faceScore: how much a placed face explains, in standard heads: 1 where all of the mean head's front is there, less
// for what is hidden, below 0 for what cannot be; larger faces explain more.
//   points   how many of the model's, from the first
//   width    mm at which a surface is half as good as one that fits
float faceScore(const FacePlacement& face, const FaceSpace& space, std::size_t points, float width);

// FaceEvidence: what speaks for a placed face. Shares are of the visible front, by weight.
//   explained  has a surface near it with a normal that agrees
//   seen       of eyes, nose and mouth: what has a surface at all
//   against    lies in fluid that sound passed through
//   relief     correlation of the model's relief in eyes, nose and mouth with that of the surface, -1..1: the
//              nose must be there, and the hollows beside it
//   gain       how high the surface's relief is beside the model's
//   residual   mm, root mean square of what is explained, along the normals
struct FaceEvidence {
  float explained = 0, seen = 0, against = 0, relief = 0, gain = 0, residual = 0;
};
FaceEvidence faceEvidence(const FacePlacement& face, const FaceSpace& space);

}  // namespace sonoskin
