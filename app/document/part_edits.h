#pragma once

#include <functional>
#include <optional>

#include "core/mesh/parts/split_part.h"
#include "core/pipeline/pipeline.h"

namespace sonoskin {

// What a person does to the parts of a surface, as options of the mesh. All need results with parts and verdicts; none
// knows the interface.

// hasParts: whether results tell of parts.
inline bool hasParts(const Results& results) { return results.parts && results.verdicts; }

// PartPick: a place of the surface and its part.
struct PartPick {
  glm::vec3 place{0};
  std::uint32_t part = 0;
};

// pickPart: the part that a ray meets first, kept or not.
//   direction  unit
std::optional<PartPick> pickPart(const Results& results, const glm::vec3& origin, const glm::vec3& direction);

// togglePart: takes the part at a place away, or brings it back. Nothing of the lists of places stays that says otherwise.
//   output   nothing if it is the last one that is kept
std::optional<MeshOptions> togglePart(const Results& results, const MeshOptions& options,
                                      const PartPick& pick);

// partAlone: this part and no other. faceAlone: the face's part.
MeshOptions partAlone(const Results& results, const MeshOptions& options, const PartPick& pick);
MeshOptions faceAlone(const Results& results, const MeshOptions& options);

// RayAt: the unit direction from the eye through a place of a stroke, 0 at its begin to 1 at its end.
using RayAt = std::function<glm::vec3(float)>;

// strokeAcross: the stroke on the part that most of a drawn line crosses, from where it enters to where it leaves it;
// nothing where the line crosses none.
std::optional<Stroke> strokeAcross(const Results& results, const glm::vec3& eye, const RayAt& rayAt);

// addStroke: splits by one more stroke.
MeshOptions addStroke(MeshOptions options, const Stroke& stroke);

}  // namespace sonoskin
