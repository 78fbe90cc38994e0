#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/mesh/atlas/atlas.h"
#include "core/mesh/atlas/atlas_bands.h"
#include "core/mesh/atlas/atlas_rim.h"

namespace sonoskin {
namespace {

// mm of a body, see AtlasOptions::unit.
constexpr float kSamePlace = 0.3f;  // claims farther apart than this are an overlap
constexpr float kShown = 1;         // a triangle is shown where the atlas has the surface this near

// Claims: per texel the first place of the surface that owns it, and whether another one does. w: 1 owned, 2 disputed.
std::vector<glm::vec4> findClaims(const Mesh& mesh, const Atlas& atlas) {
  require(atlas.corners.size() == mesh.triangles.size(), "The atlas belongs to another mesh.");
  std::vector<glm::vec4> claims(std::size_t(atlas.size.x) * std::size_t(atlas.size.y), glm::vec4(0));
  const AtlasBands bands(atlas.size, atlas.corners);
  parallelFor(bands.count(), [&](std::ptrdiff_t b) {
    for (const std::uint32_t* t = bands.begin(int(b)); t != bands.end(int(b)); ++t) {
      const auto& [i, j, k] = mesh.triangles[*t];
      const glm::vec3 &pi = mesh.positions[i], &pj = mesh.positions[j], &pk = mesh.positions[k];
      forEachTexel(atlas.corners[*t], atlas.size.x, bands.rows(int(b)),
                   [&](int x, int y, const glm::vec3& w) {
                     glm::vec4& claim = claims[std::size_t(y) * std::size_t(atlas.size.x) + std::size_t(x)];
                     const glm::vec3 place = w.x * pi + w.y * pj + w.z * pk;
                     if (claim.w == 0)
                       claim = glm::vec4(place, 1);
                     else if (glm::length(place - glm::vec3(claim)) > kSamePlace * atlas.unit)
                       claim.w = 2;
                   });
    }
  });
  return claims;
}

// Whether the atlas has a place near a triangle's centre at the texel there or one beside it.
bool isShown(const Atlas& atlas, const std::vector<glm::vec4>& claims, const Corners& corners,
             const glm::vec3& centre) {
  const glm::ivec2 at((corners[0] + corners[1] + corners[2]) / 3.f);
  for (int y = std::max(at.y - 1, 0); y <= std::min(at.y + 1, atlas.size.y - 1); ++y)
    for (int x = std::max(at.x - 1, 0); x <= std::min(at.x + 1, atlas.size.x - 1); ++x) {
      const glm::vec4& claim = claims[std::size_t(y) * std::size_t(atlas.size.x) + std::size_t(x)];
      if (claim.w > 0 &&
          glm::length(glm::vec3(claim) - centre) < std::max(kShown * atlas.unit, 3 * atlas.texel))
        return true;
    }
  return false;
}

// The largest mm per texel of a triangle over the nominal one: the larger singular value of the map to the surface.
double stretchOf(const Facets& facets, const Atlas& atlas, std::size_t t) {
  constexpr double kMost = 1000;  // of a triangle that the projection sees from the side
  const Barycentric plane(atlas.corners[t]);
  if (!plane.valid()) return kMost;
  const auto& [i, j, k] = facets.mesh.triangles[t];
  const glm::dvec3 second(facets.mesh.positions[j] - facets.mesh.positions[i]),
      third(facets.mesh.positions[k] - facets.mesh.positions[i]);
  const glm::dvec3 du = double(plane.d1.x) * second + double(plane.d2.x) * third,
                   dv = double(plane.d1.y) * second + double(plane.d2.y) * third;
  const double e = glm::dot(du, du), f = glm::dot(du, dv), g = glm::dot(dv, dv);
  const double larger = 0.5 * (e + g + std::sqrt((e - g) * (e - g) + 4 * f * f));
  return std::min(kMost, std::sqrt(larger) / double(atlas.texel));
}

void measureStretch(const Facets& facets, const Atlas& atlas, double area, AtlasCheck& check) {
  std::vector<std::pair<double, float>> stretches(facets.size());  // stretch, area
  parallelItems(facets.size(), kFacetsPerTask, [&](std::size_t t) {
    stretches[t] = {stretchOf(facets, atlas, t), facets.area(t)};
  });
  std::sort(stretches.begin(), stretches.end());
  double below = 0, steep = 0;
  for (const auto& [stretch, share] : stretches) {
    if (share == 0) continue;
    if (below <= 0.99 * area) check.stretch99 = stretch;
    below += double(share);
    if (stretch > 1 / 0.3) steep += double(share);
    check.stretchMax = stretch;
  }
  check.steep = area > 0 ? steep / area : 0;
}

double seamsOf(const Facets& facets, const Atlas& atlas) {
  double length = 0;
  for (const RimSide& side : rimSides(facets, atlas)) {
    if (facets.opposite[3 * side.triangle + side.corner] == kNoHalfEdge) continue;
    const Triangle& t = facets.mesh.triangles[side.triangle];
    length += 0.5 * double(glm::length(facets.mesh.positions[t[(side.corner + 1) % 3]] -
                                       facets.mesh.positions[t[side.corner]]));
  }
  return length;
}

// What claims alone say.
AtlasCheck checkOf(const std::vector<glm::vec4>& claims, double area, const Atlas& atlas) {
  AtlasCheck check;
  check.charts = atlas.charts;
  check.area = area / (double(atlas.unit) * double(atlas.unit));
  std::size_t owned = 0, disputed = 0;
  for (const glm::vec4& claim : claims) {
    owned += claim.w > 0;
    disputed += claim.w > 1;
  }
  check.overlap = owned > 0 ? double(disputed) / double(owned) : 0;
  return check;
}

}  // namespace

AtlasCheck checkAtlas(const Mesh& mesh, const Atlas& atlas) { return checkAtlas(Facets(mesh), atlas); }

AtlasCheck checkAtlas(const Facets& facets, const Atlas& atlas) {
  const std::vector<glm::vec4> claims = findClaims(facets.mesh, atlas);
  const double area = facets.area();
  AtlasCheck check = checkOf(claims, area, atlas);
  double hidden = 0;
  for (std::size_t t = 0; t < facets.size(); ++t)
    if (!isShown(atlas, claims, atlas.corners[t], facets.centre[t])) hidden += double(facets.area(t));
  check.uncovered = area > 0 ? hidden / area : 0;
  measureStretch(facets, atlas, area, check);
  check.seamLength = seamsOf(facets, atlas);
  return check;
}

AtlasCheck checkOverlap(const Facets& facets, const Atlas& atlas) {
  return checkOf(findClaims(facets.mesh, atlas), facets.area(), atlas);
}

}  // namespace sonoskin
