#include "app/document/part_edits.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/mesh/search/ray_hit.h"

namespace sonoskin {
namespace {

// Hundredths of a mm: more would be noise in a recipe.
std::array<double, 3> placeOf(const glm::vec3& p) {
  std::array<double, 3> place{};
  for (int i = 0; i < 3; ++i) place[std::size_t(i)] = std::round(100 * double(p[i])) / 100;
  return place;
}

glm::vec3 vec(const std::array<double, 3>& place) { return {place[0], place[1], place[2]}; }

// Drops the places of a list that name a part.
void forget(Places& places, const PartedSurface& surface, std::uint32_t part) {
  std::erase_if(places,
                [&](const auto& place) { return partAt(surface.mesh, surface.parts, vec(place)) == part; });
}

std::size_t faceOf(const std::vector<PartVerdict>& verdicts) {
  const auto face =
      std::find_if(verdicts.begin(), verdicts.end(), [](const PartVerdict& v) { return v.isFace; });
  return std::size_t(face - verdicts.begin());
}

// DrawnLine: a line over a surface, its places from 0 to 1.
struct DrawnLine {
  const Results& results;
  const glm::vec3& eye;
  const RayAt& rayAt;

  std::optional<PartPick> at(float place) const { return pickPart(results, eye, rayAt(place)); }
};

// Where along a line it leaves a part: between a place on it and one beyond.
float edgeBetween(const DrawnLine& line, std::uint32_t part, float on, float off) {
  constexpr int kHalvings = 4;
  for (int i = 0; i < kHalvings; ++i) {
    const float middle = 0.5f * (on + off);
    const auto pick = line.at(middle);
    (pick && pick->part == part ? on : off) = middle;
  }
  return on;
}

}  // namespace

std::optional<PartPick> pickPart(const Results& results, const glm::vec3& origin,
                                 const glm::vec3& direction) {
  const auto hit = firstTriangle(results.parts->mesh, origin, direction);
  if (!hit) return std::nullopt;
  return PartPick{origin + hit->distance * direction, results.parts->parts.ofTriangle[hit->triangle]};
}

std::optional<MeshOptions> togglePart(const Results& results, const MeshOptions& options,
                                      const PartPick& pick) {
  const PartVerdict& verdict = (*results.verdicts)[pick.part];
  const auto kept = std::count_if(results.verdicts->begin(), results.verdicts->end(),
                                  [](const PartVerdict& v) { return v.kept; });
  if (verdict.kept && kept == 1) return std::nullopt;
  MeshOptions changed = options;
  forget(changed.partsAdd, *results.parts, pick.part);
  forget(changed.partsDrop, *results.parts, pick.part);
  if (verdict.kept && verdict.proposed) changed.partsDrop.push_back(placeOf(pick.place));
  if (!verdict.kept && !verdict.proposed) changed.partsAdd.push_back(placeOf(pick.place));
  return changed;
}

MeshOptions partAlone(const Results& results, const MeshOptions& options, const PartPick& pick) {
  MeshOptions changed = options;
  changed.parts = PartsChoice::automatic;
  changed.companions = 1;
  changed.partsAdd.clear();
  changed.partsDrop.clear();
  const std::size_t face = faceOf(*results.verdicts);
  if (face == pick.part) return changed;
  changed.partsAdd.push_back(placeOf(pick.place));
  changed.partsDrop.push_back(placeOf(results.parts->parts.parts[face].place));
  return changed;
}

MeshOptions faceAlone(const Results& results, const MeshOptions& options) {
  const std::size_t face = faceOf(*results.verdicts);
  return partAlone(results, options, {results.parts->parts.parts[face].place, std::uint32_t(face)});
}

std::optional<Stroke> strokeAcross(const Results& results, const glm::vec3& eye, const RayAt& rayAt) {
  constexpr int kSamples = 8;
  const DrawnLine line{results, eye, rayAt};
  std::vector<std::optional<PartPick>> picks;
  std::map<std::uint32_t, int> counts;
  for (int i = 0; i <= kSamples; ++i) {
    picks.push_back(line.at(float(i) / kSamples));
    if (picks.back()) ++counts[picks.back()->part];
  }
  if (counts.empty()) return std::nullopt;
  const std::uint32_t part = std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) {
                               return a.second < b.second;
                             })->first;
  const auto isOn = [&](int i) { return picks[std::size_t(i)] && picks[std::size_t(i)]->part == part; };
  int first = 0, last = kSamples;
  while (!isOn(first)) ++first;
  while (!isOn(last)) --last;
  const auto at = [](int i) { return float(i) / kSamples; };
  const float from = first == 0 ? 0 : edgeBetween(line, part, at(first), at(first - 1));
  const float to = last == kSamples ? 1 : edgeBetween(line, part, at(last), at(last + 1));
  const auto begin = line.at(from), end = line.at(to);
  if (!begin || !end || begin->place == end->place) return std::nullopt;
  return Stroke{begin->place, end->place, eye};
}

MeshOptions addStroke(MeshOptions options, const Stroke& stroke) {
  for (const glm::vec3& p : {stroke.from, stroke.to, stroke.eye}) options.partsCut.push_back(placeOf(p));
  return options;
}

}  // namespace sonoskin
