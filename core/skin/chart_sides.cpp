#include "core/skin/chart_sides.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/atlas/atlas_rim.h"

namespace sonoskin {
namespace {

constexpr float kStep = 0.5f;         // texels between places
constexpr float kOwnedMoves = 0.15f;  // for 1 of a texel beyond the side
constexpr float kDamping = 0.15f;     // for a look's shares, whose squares add up to 0.25 or more
constexpr int kRounds = 10;

bool touch(const Triangle& a, const Triangle& b) {
  return std::ranges::any_of(a, [&](std::uint32_t v) { return std::ranges::find(b, v) != b.end(); });
}

// Whether the chart shows another sheet of the surface at a place than the one that has it: owned texels of the look lie
// too far away, and not on a neighbour.
bool showsAnotherSheet(const SkinSurface& surface, const ChartSides::Place& place) {
  constexpr float kFarthest = 1.5f;  // texels
  const std::vector<glm::vec3>& p = surface.mesh->positions;
  const std::vector<Triangle>& triangles = surface.mesh->triangles;
  const auto& [i, j, k] = triangles[place.triangle];
  const glm::vec3 here = place.weights.x * p[i] + place.weights.y * p[j] + place.weights.z * p[k];
  return std::ranges::any_of(place.look.texels, [&](std::uint32_t texel) {
    const glm::vec4& shown = surface.maps.position[texel];
    return shown.w == 1 && glm::distance(glm::vec3(shown), here) > kFarthest * surface.atlas.texel &&
           !touch(triangles[place.triangle], triangles[surface.maps.triangle[texel]]);
  });
}

}  // namespace

ChartSides::ChartSides(const SkinSurface& surface) {
  if (surface.pointBased) return;
  for (const RimSide& side : rimSides(Facets(*surface.mesh), surface.atlas)) {
    if (side.triangle >= surface.shown) continue;
    const Corners& corners = surface.atlas.corners[side.triangle];
    const std::size_t from = side.corner, to = (from + 1) % 3;
    const int steps = std::max(1, int(std::ceil(glm::distance(corners[from], corners[to]) / kStep)));
    for (int s = 0; s < steps; ++s) {
      glm::vec3 weights(0);
      weights[int(to)] = (float(s) + 0.5f) / float(steps);
      weights[int(from)] = 1 - weights[int(to)];
      add(surface, side.triangle, weights);
    }
  }
}

void ChartSides::add(const SkinSurface& surface, std::uint32_t triangle, const glm::vec3& weights) {
  const AtlasMaps& maps = surface.maps;
  Place place{triangle, weights,
              lookBetween(maps.size, placeInAtlas(surface.atlas.corners[triangle], weights)), glm::vec4(0)};
  glm::vec4& shares = place.look.shares;
  for (int k = 0; k < 4; ++k)
    if (maps.position[place.look.texels[std::size_t(k)]].w == 0) shares[k] = 0;
  const float covered = shares.x + shares.y + shares.z + shares.w;
  if (covered == 0 || showsAnotherSheet(surface, place)) return;
  shares /= covered;
  for (int k = 0; k < 4; ++k)
    place.steps[k] = shares[k] * (maps.position[place.look.texels[std::size_t(k)]].w < 1 ? 1 : kOwnedMoves);
  place.steps /= kDamping + glm::dot(shares, place.steps);
  places_.push_back(place);
}

void ChartSides::fit(std::span<const glm::vec4> light, std::vector<glm::vec4>& map) const {
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto& [texels, shares] = places_[i].look;
      glm::vec4 missing = light[i];
      for (int k = 0; k < 4; ++k) missing -= shares[k] * map[texels[std::size_t(k)]];
      for (int k = 0; k < 4; ++k) {
        glm::vec4& texel = map[texels[std::size_t(k)]];
        texel = glm::max(texel + places_[i].steps[k] * missing, 0.f);
      }
    }
}

}  // namespace sonoskin
