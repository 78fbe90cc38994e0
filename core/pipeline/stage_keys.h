#pragma once

#include "core/base/hash.h"
#include "core/pipeline/parameters.h"

namespace sonoskin {

// StageKeys: fingerprints of all that the result of each stage depends on: equal keys, equal results. They follow from the
// scan and the parameters alone, so that anybody can ask whether a result is what the parameters would give now.
//   enhanced    what is classified; the scan's own key where nothing is enhanced
//   prepared    low-pass, field of view and beams
//   face        a zero key where no face is looked for
//   fit         the function, by the options of the chosen method alone
//   pieces      all of its surface; parts: the same in parts; kept: what was chosen of it
//   mesh        what is shown: kept, and cleaned where the options ask for that
struct StageKeys {
  Key enhanced, prepared, classified, points, evidence, face, fit, pieces, parts, kept, mesh, print;
};

// stageKeys: of a scan with a fingerprint (Scan::key), of which something is erased (Scan::erasedKey).
StageKeys stageKeys(const Key& scan, const Key& erased, const Parameters& parameters);

// The key of one stage's result, from those of what it is made from and the options that it reads.
Key enhancedKey(const Key& scan, const EnhancementOptions& options);
Key coarserKey(const Key& volume);  // of half the resolution; in previews alone
Key preparedKey(const Key& volume, const Parameters& parameters);
//   live  solved as far as somebody needs who turns a slider: another result
Key classifiedKey(const Key& prepared, const ClassificationOptions& options, bool live = false);
Key pointsKey(const Key& classified, const Key& erased, const Parameters& parameters);
Key evidenceKey(const Key& points);
Key faceKey(const Key& points, const FaceOptions& options);
Key fitKey(const Key& points, const Parameters& parameters);
Key piecesKey(const Key& fit, const MeshOptions& options);
Key partsKey(const Key& pieces, const MeshOptions& options);
//   surface  the key of its parts, or of its pieces where whole ones are chosen: these do not depend on the face
//   face     zero where none was looked for, as by somebody who turns a slider
Key keptKey(const Key& surface, const Key& face, const Parameters& parameters);
Key cleanKey(const Key& kept, const MeshOptions& options);
Key printKey(const Key& mesh, const PrintOptions& options);

// parametersKey: of all parameters, whether or not a stage depends on them.
Key parametersKey(const Parameters& parameters);

}  // namespace sonoskin
