#pragma once

#include <array>
#include <optional>

#include "core/mesh/parts/parts.h"
#include "core/volume/scan.h"

namespace sonoskin {

// FaceSite: where a face was found; world mm.
//   places, normals   on its skin as it is expected, evenly spread
//   ears, up, front   the middle between the ears; unit, from the chin to the crown and where the nose points
//   height            of the head, from the chin to the crown
struct FaceSite {
  std::vector<glm::vec3> places, normals;
  glm::vec3 ears{0}, up{0, 0, 1}, front{0, -1, 0};
  float height = 0;
};

// PartReason: why a part is kept or off.
//   face      it is the face's; onFace: most of it lies where the face was found; beside, joins: it belongs to the baby,
//             see chooseParts; asked: a person brought it back; all: every part is kept
//   hidden    the probe sees little of it; debris: too small, or strands; aside: little of it
//             lies in the middle of the view, and it joins nothing; far: nothing that is kept is near; wall: a flat or
//             hollow sheet before the face; dropped: a person took it away
enum class PartReason { face, onFace, beside, joins, asked, all, hidden, debris, aside, far, wall, dropped };
constexpr std::array<const char*, 12> enumNames(PartReason) {
  return {"face",   "on-face", "beside", "joins", "asked", "all",
          "hidden", "debris",  "aside",  "far",   "wall",  "dropped"};
}

// PartVerdict: whether a part is kept, and why.
//   proposed  whether it would be kept if nobody had asked for it or taken it away
//   isFace    it is the face's part, kept or not
//   share   of the middle of the probe's view that the part fills, as a share of what the face's part fills; seen: of all
//           of the view (viewShares)
struct PartVerdict {
  bool kept = false, proposed = false, isFace = false;
  PartReason reason = PartReason::hidden;
  double share = 0, seen = 0;
};

// PartView: what the choice of parts is made from.
//   middle      a point on the middle beam, mm
//   companions  share of the view from which a part beside the face's is kept
//   face        nothing where none was found
//   dropped     parts that a person took away: they bring no others near
struct PartView {
  Beam beam;
  glm::dvec3 middle{0};
  double companions = 0.08;
  std::optional<FaceSite> face = {};
  std::vector<std::uint32_t> dropped = {};
};

// chooseParts: which parts are the face and what belongs to the baby.
//   method   The face's part fills most of the middle of the probe's view and bulges like a head; where a face was found it is
//            the part with most area there, and parts that lie there by half are kept, such as a chin behind a deep mouth;
//            what lies below the chin is the body; what lies neither there nor before the ears is off: no limb does.
//            Beside it stays what fills `companions` of that middle, or twice that of
//            all of the view, and lies within 20 mm
//            of what is kept, without a flat or hollow sheet before the face: a wall, a placenta. What fills little of the
//            view stays if it joins what is kept along a long border or a narrow gap, or touches it and is
//            round as limbs are, and is no strand, unless `companions`
//            is 1, which leaves the face alone.
//   output   one per part
//   cost     O(n); 400k triangles in 0.04 s
std::vector<PartVerdict> chooseParts(const Mesh& mesh, const SurfaceParts& parts, const PartView& view);

}  // namespace sonoskin
