#include "core/mesh/parts/choose_parts.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/search/point_grid.h"
#include "core/mesh/view_shares.h"

namespace sonoskin {
namespace {

constexpr double kNear = 20, kTouching = 3;  // mm between parts
// Shares of the view, and of its middle, below which a part is hidden.
constexpr double kSeen = 0.018, kSeenMiddle = 0.01;
constexpr float kOnFace = 5,
                kSameSide = 0.5f;  // mm from a face that was found; least cosine between the normals
constexpr float kChin = -0.33f, kBeforeEars = 0.17f;  // heights of the head, from the middle between the ears
constexpr double kMostOnFace = 0.5;                   // of a part's area
constexpr double kLeastArea = 40, kScrap = 300;       // mm²
constexpr double kJoins = 0.8;       // border with what is kept, by the root of the part's area
constexpr double kStrand = 1 / 5.5;  // 1/mm: curvature of strands 5.5 mm thick
// Of the parts of arms and hands: the share of the view, and the curvatures, 1/mm.
constexpr double kLimbSeen = 0.05, kRoundest = 1 / 60.0, kThinnest = 1 / 8.0;
constexpr double kFlat = 1 / 250.0;            // 1/mm: below it a sheet is flat or hollow
constexpr double kHead = 0.012, kLimb = 0.06;  // 1/mm: curvatures of heads lie between
constexpr double kWallShare = 0.3;             // of the face's area, from which a sheet is a wall

// How much a part bulges like a head: 0.3 to 1.
double headLike(const Part& part) {
  const double c = part.curvature;
  const double like = c <= 0 ? 0 : c < kHead ? c / kHead : c > kLimb ? kLimb / c : 1;
  return 0.3 + 0.7 * like;
}

// Neighbours: how near the parts are to those that are kept.
class Neighbours {
 public:
  explicit Neighbours(const SurfaceParts& parts)
      : graph_(parts.graph),
        part_(graph_.size(), 0),
        patches_(parts.parts.size()),
        grid_(graph_.patches.centre, 5) {
    for (std::size_t t = parts.ofTriangle.size(); t-- > 0;)
      part_[graph_.patches.ofTriangle[t]] = parts.ofTriangle[t];
    for (std::uint32_t p = 0; p < graph_.size(); ++p) patches_[part_[p]].push_back(p);
  }

  const std::vector<std::uint32_t>& patches(std::size_t part) const { return patches_[part]; }

  // The length of a part's border with those that count, mm.
  double border(std::size_t part, const std::vector<bool>& counts) const {
    double length = 0;
    for (const std::uint32_t p : patches_[part])
      for (std::uint32_t i = graph_.patches.start[p]; i < graph_.patches.start[p + 1]; ++i)
        if (counts[part_[graph_.patches.neighbours[i]]]) length += double(graph_.border[i]);
    return length;
  }

  // Whether a part comes nearer than `reach` mm to one that counts.
  bool isNear(std::size_t part, double reach, const std::vector<bool>& counts) const {
    const float r = float(reach);
    for (const std::uint32_t p : patches_[part]) {
      const glm::vec3& from = graph_.patches.centre[p];
      bool found = false;
      grid_.forEachRun(from, r, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t s = first; s < last && !found; ++s) {
          const std::uint32_t other = grid_.order()[s];
          const glm::vec3 away = graph_.patches.centre[other] - from;
          found = counts[part_[other]] && glm::dot(away, away) < r * r;
        }
      });
      if (found) return true;
    }
    return false;
  }

 private:
  const PartGraph& graph_;
  std::vector<std::uint32_t> part_;  // per patch
  std::vector<std::vector<std::uint32_t>> patches_;
  PointGrid grid_;
};

// The area of each part that lies on a face, mm².
std::vector<double> areasOnFace(const SurfaceParts& parts, const Neighbours& all, const FaceSite& face) {
  const PointGrid grid(face.places, kOnFace);
  const auto isOnFace = [&](std::uint32_t patch) {
    const glm::vec3& centre = parts.graph.patches.centre[patch];
    bool found = false;
    grid.forEachRun(centre, kOnFace, [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t s = first; s < last && !found; ++s) {
        const std::uint32_t at = grid.order()[s];
        const glm::vec3 away = centre - face.places[at];
        found = glm::dot(away, away) < kOnFace * kOnFace &&
                glm::dot(parts.graph.normal[patch], face.normals[at]) > kSameSide;
      }
    });
    return found;
  };
  std::vector<double> areas(parts.parts.size(), 0);
  for (std::size_t p = 0; p < areas.size(); ++p)
    for (const std::uint32_t patch : all.patches(p))
      if (isOnFace(patch)) areas[p] += double(parts.graph.area[patch]);
  return areas;
}

// The part that fills most of the view's middle and bulges like a head.
std::size_t mostLikeAHead(const SurfaceParts& parts, const std::vector<double>& shares) {
  std::size_t best = 0;
  for (std::size_t p = 1; p < shares.size(); ++p)
    if (shares[p] * headLike(parts.parts[p]) > shares[best] * headLike(parts.parts[best])) best = p;
  return best;
}

double depthOf(const Part& part, const Beam& beam) {
  const glm::dvec3 place(part.centre);
  return beam.apex ? glm::distance(place, *beam.apex) : glm::dot(place, beam.axis);
}

// Whether a part is a flat or hollow sheet before the face.
bool isWall(const Part& part, const Part& face, const Beam& beam) {
  return part.curvature < kFlat && part.area > kWallShare * face.area &&
         depthOf(part, beam) < depthOf(face, beam);
}

// Whether a part lies where hands, arms and shoulders do: below the chin, or before the ears.
bool isBelowChin(const Part& part, const FaceSite& face) {
  return glm::dot(part.centre - face.ears, face.up) < kChin * face.height;
}
bool mayBeLimb(const Part& part, const FaceSite& face) {
  return isBelowChin(part, face) || glm::dot(part.centre - face.ears, face.front) > kBeforeEars * face.height;
}

// Choice: what is known while parts are chosen.
//   face    the part that is the measure of the others
//   onFace  of each part the area that lies on the face, mm²
//   counts  the parts that have been chosen so far
struct Choice {
  const SurfaceParts& parts;
  const Neighbours& all;
  const PartView& view;
  std::size_t face;
  std::vector<double> onFace;
  std::vector<bool> counts;
};

// Why a part stays or goes, beside those that count so far.
PartReason reasonFor(std::size_t p, const PartVerdict& shown, const Choice& choice) {
  const auto& [parts, all, view, faceAt, onFace, counts] = choice;
  const Part &part = parts.parts[p], &face = parts.parts[faceAt];
  const double share = shown.share;
  if (shown.seen < kSeen && share < kSeenMiddle) return PartReason::hidden;
  if (isWall(part, face, view.beam)) return PartReason::wall;
  if (part.area < kLeastArea) return PartReason::debris;
  if (!all.isNear(p, kNear, counts)) return PartReason::far;
  if (onFace[p] > kMostOnFace * part.area) return PartReason::onFace;
  if (view.companions >= 1) return PartReason::hidden;
  if (view.face && !mayBeLimb(part, *view.face)) return PartReason::aside;
  const bool isBody = view.face && shown.seen >= kLimbSeen && isBelowChin(part, *view.face);
  if (isBody || std::max(share, 0.5 * shown.seen) >= view.companions) return PartReason::beside;
  if (part.curvature > kStrand) return PartReason::debris;
  const double border = all.border(p, counts);
  const bool touches = border > 0 || all.isNear(p, kTouching, counts);
  const bool limb = shown.seen >= kLimbSeen && part.curvature > kRoundest && part.curvature < kThinnest;
  const bool joins = border > kJoins * std::sqrt(part.area) || (touches && (border == 0 || limb));
  return joins ? PartReason::joins : part.area < kScrap ? PartReason::debris : PartReason::aside;
}

}  // namespace

std::vector<PartVerdict> chooseParts(const Mesh& mesh, const SurfaceParts& parts, const PartView& view) {
  std::vector<PartVerdict> verdicts(parts.parts.size());
  if (verdicts.empty()) return verdicts;
  const ViewShares shown = viewShares(mesh, parts.ofTriangle, parts.parts.size(), view.beam, view.middle);
  const Neighbours all(parts);
  const std::vector<double> onFace =
      view.face ? areasOnFace(parts, all, *view.face) : std::vector<double>(verdicts.size(), 0);
  const auto most = std::ranges::max_element(onFace);
  const std::size_t face =
      *most > 0 ? std::size_t(most - onFace.begin()) : mostLikeAHead(parts, shown.centred);
  for (std::size_t p = 0; p < verdicts.size(); ++p) {
    verdicts[p].share = shown.centred[p] / std::max(shown.centred[face], 1e-9);
    verdicts[p].seen = shown.seen[p] / std::max(shown.seen[face], 1e-9);
  }
  std::vector<bool> dropped(verdicts.size(), false);
  Choice choice{parts, all, view, face, onFace, std::vector<bool>(verdicts.size(), false)};
  for (const std::uint32_t p : view.dropped) dropped[p] = true;
  verdicts[face].reason = PartReason::face;
  verdicts[face].isFace = verdicts[face].proposed = true;
  choice.counts[face] = true;  // it is the measure of the others even where it is taken away
  // Each part that is kept may bring others near; the larger come first.
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t p = 0; p < verdicts.size(); ++p) {
      if (verdicts[p].proposed) continue;
      verdicts[p].reason = reasonFor(p, verdicts[p], choice);
      const PartReason reason = verdicts[p].reason;
      if (reason != PartReason::onFace && reason != PartReason::beside && reason != PartReason::joins)
        continue;
      verdicts[p].proposed = grown = true;
      choice.counts[p] = !dropped[p];
    }
  }
  for (std::size_t p = 0; p < verdicts.size(); ++p) {
    verdicts[p].kept = verdicts[p].proposed && !dropped[p];
    if (dropped[p]) verdicts[p].reason = PartReason::dropped;
  }
  return verdicts;
}

}  // namespace sonoskin
