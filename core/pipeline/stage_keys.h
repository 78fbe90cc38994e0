#pragma once

#include "core/base/hash.h"
#include "core/pipeline/parameters.h"

namespace sonoskin {

// Precision: which short cuts a run may take for somebody who turns a slider; the others make another result.
//   solved  the classification is solved to its tolerance
//   face    the face is looked for, if face.find
struct Precision {
  bool solved = true, face = true;
};

// StageKeys: fingerprints of all that the result of each stage depends on: equal keys, equal results. They follow from the
// scan and the parameters alone, so that anybody can ask whether a result is what the parameters would give now.
//   enhanced    what is classified; the scan's own key where nothing is enhanced
//   prepared    low-pass, field of view and beams
//   face        a zero key where no face is looked for
//   fit         the function, by the options of the chosen method alone
//   pieces      all of its surface; parts: the same in parts; kept: what was chosen of it
//   mesh        what is shown: kept, and cleaned where the options ask for that
struct StageKeys {
  Key enhanced, prepared, classified, points, face, fit, pieces, parts, kept, mesh, print;
};

// stageKeys: of a scan with a fingerprint (Scan::key), of which something is erased (Scan::erasedKey).
StageKeys stageKeys(const Key& scan, const Key& erased, const Parameters& parameters,
                    const Precision& precision = {});

// parametersKey: of all parameters, whether or not a stage depends on them.
Key parametersKey(const Parameters& parameters);

}  // namespace sonoskin
