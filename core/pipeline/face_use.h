#pragma once

#include <optional>
#include <string>

#include "core/face/face_fit.h"
#include "core/mesh/parts/choose_parts.h"
#include "core/pipeline/parameters.h"

namespace sonoskin {

// isCertain: whether a face was found that is certain enough to be used.
bool isCertain(const FaceFit* face, const FaceOptions& options);

// landmarksWithFace: the landmarks set by hand, and for those that are not the ones of a face that is certain.
LandmarkOptions landmarksWithFace(const Parameters& parameters, const FaceFit* face);

// siteOf: where the skin of a face is expected that is certain enough to be used; nothing where there is none.
std::optional<FaceSite> siteOf(const FaceFit* face, const FaceOptions& options);

// faceText: what was found, as one sentence for people; empty where nothing was looked for.
std::string faceText(const FaceFit* face, const FaceOptions& options);

// scaleWarning: one sentence where a face that is certain is larger or smaller than heads are, as with a wrong spacing;
// else empty.
std::string scaleWarning(const FaceFit* face, const FaceOptions& options);

}  // namespace sonoskin
