#include "core/skin/skin_surface.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/mesh/atlas/seen_triangles.h"
#include "core/mesh/repair/decimate.h"
#include "core/mesh/search/near_triangles.h"

namespace sonoskin {
namespace {

constexpr int kMaxSize = 8192;                  // texels a side
constexpr std::size_t kTrianglesPerChart = 20;  // at least, of an atlas that light is not blurred in

std::shared_ptr<const Mesh> reduced(std::shared_ptr<const Mesh> mesh, int triangles,
                                    const Progress& progress) {
  const bool isReduced = triangles > 0 && mesh->triangles.size() > std::size_t(triangles);
  const bool hasNormals = mesh->normals.size() == mesh->positions.size();
  if (!isReduced && hasNormals) return mesh;
  Mesh own = isReduced ? decimateMesh(*mesh, std::size_t(triangles), progress) : *mesh;
  if (!hasNormals) computeNormals(own);
  return std::make_shared<const Mesh>(std::move(own));
}

// The atlas of the mesh's own coordinates if that is asked for and good, else one made for it.
void findAtlas(const Facets& facets, const AtlasOptions& options, const SkinQuality& quality,
               SkinSurface& surface, const Progress& progress) {
  const Mesh& mesh = facets.mesh;
  if (std::optional<Atlas> own =
          quality.ownCoordinates ? atlasFromCoordinates(mesh, options) : std::nullopt) {
    surface.check = checkOverlap(facets, *own);
    surface.atlas = std::move(*own);
    if (surface.check.good()) return;
  }
  if (quality.ownCoordinates)
    log(LogLevel::warning,
        "The surface brings no texture coordinates, or they show parts of it on top of each other; "
        "a map is made for it instead.");
  surface.atlas = buildAtlas(facets, options, progress.part(0, 0.8));
  surface.check = checkOverlap(facets, surface.atlas);
  // Points ask for no more of charts than that texels go further than they do in blocks.
  const bool fits = std::max(surface.atlas.size.x, surface.atlas.size.y) <= options.maxSize,
             isGood = quality.diffusion > DiffusionMethod::blurs
                          ? surface.check.flat() &&
                                std::size_t(surface.check.charts) * kTrianglesPerChart <= facets.size()
                          : surface.check.good();
  surface.pointBased = !isGood || !fits;
  if (!surface.pointBased) return;
  surface.atlas = blockAtlas(mesh, options.texel, options.maxSize, options.maxTexels);
  surface.atlas.unit = float(options.unit);
}

// The texels of an object of that area: as the quality has them, but neither so many nor so few on all of the surface.
// Where they are so large that light does not get from one to the next, what it spreads over cannot be seen.
double texelFor(double area, const SkinQuality& quality) {
  constexpr double kCovered = 0.3;  // of an atlas: skirts, gaps and charts' corners are the rest
  constexpr double kLeast = 4096;   // on a thing that is smaller than a nose
  return std::clamp(quality.texel, std::sqrt(area / (kCovered * quality.texels)),
                    std::max(std::sqrt(area / kLeast), 1e-9));
}

// Parts the mesh into what a picture shows, what light spreads to it from, and the rest.
// Blurs find light on charts that are whole; points need samples of it alone.
void takeShown(std::shared_ptr<const Mesh> mesh, const SkinSight& sight, bool byPoints,
               SkinSurface& surface) {
  const Mesh& whole = *mesh;
  const std::vector<std::uint8_t> isShown = seenTriangles(whole, sight.viewProjection, sight.size);
  const std::vector<std::uint8_t> isLit = trianglesWithin(whole, isShown, sight.reach);
  std::vector<std::uint32_t> shown, lit, hidden;
  for (std::uint32_t t = 0; t < isLit.size(); ++t)
    (isShown[t] || (isLit[t] && !byPoints) ? shown : isLit[t] ? lit : hidden).push_back(t);
  surface.mesh = std::move(mesh);
  // What shows nothing is lit as a whole: a surface cannot be without triangles.
  if (shown.empty() || shown.size() == whole.triangles.size()) return;
  surface.hidden = selectTriangles(whole, hidden);
  surface.shown = shown.size();
  shown.insert(shown.end(), lit.begin(), lit.end());
  surface.mesh = std::make_shared<const Mesh>(selectTriangles(whole, shown));
}

// Charts end between what is shown and what only gives light.
void cutAtShown(std::size_t shown, Facets& facets) {
  for (std::uint32_t h = 0; h < facets.opposite.size(); ++h) {
    std::uint32_t& opposite = facets.opposite[h];
    if (opposite != kNoHalfEdge && (h / 3 < shown) != (opposite / 3 < shown)) opposite = kNoHalfEdge;
  }
}

AtlasOptions atlasOptions(double area, const glm::vec3& front, const SkinQuality& quality,
                          const SkinSight& sight) {
  AtlasOptions options;
  const double texel = texelFor(area, quality);
  options.unit = texel / quality.texel;
  options.texel = std::max(texel, double(sight.sample));
  options.maxTexels = quality.texels;
  options.skirt = quality.skirt;
  options.front = front;
  options.maxSize = kMaxSize;
  return options;
}

}  // namespace

void SkinSurface::keepForLight() {
  // Vectors give memory back when they are destroyed, not when they are assigned to.
  AtlasMaps kept{maps.size, std::move(maps.position), {}, {}, {}, std::move(maps.triangle)};
  maps = std::move(kept);
}

SkinQuality fullQuality() { return {}; }

SkinQuality pictureQuality() {
  SkinQuality quality = fullQuality();
  quality.diffusion = DiffusionMethod::points;
  quality.skirt = 0;  // points need none
  quality.texels = 4e6;
  return quality;
}

SkinQuality lightQuality() {
  SkinQuality quality;
  quality.triangles = 100000;
  quality.texel = 0.30;
  quality.texels = 4e6;
  quality.skirt = 5;
  quality.shadowSize = 1024;
  quality.shadowTaps = 9;
  quality.detailLayers = 1;
  return quality;
}

std::shared_ptr<SkinSurface> prepareSkin(std::shared_ptr<const Mesh> mesh, const glm::vec3& front,
                                         const SkinQuality& quality, const SkinSight& sight,
                                         const Progress& progress) {
  require(mesh && !mesh->empty(), "There is no surface to show as skin.");
  auto surface = std::make_shared<SkinSurface>();
  const std::shared_ptr<const Mesh> whole =
      reduced(std::move(mesh), quality.triangles, progress.part(0, 0.2));
  surface->mesh = whole;
  if (!sight.isAll()) takeShown(whole, sight, quality.diffusion > DiffusionMethod::blurs, *surface);
  Facets facets(*surface->mesh, progress.part(0.2, 0.25));
  const SurfaceTraits traits = measureTraits(facets, *whole, 128, 2, progress.part(0.25, 0.5));
  cutAtShown(surface->shown, facets);
  AtlasOptions options = atlasOptions(surfaceArea(*whole), front, quality, sight);
  options.fine = surface->shown;
  findAtlas(facets, options, quality, *surface, progress.part(0.5, 0.8));
  surface->vertices = splitAtSeams(*surface->mesh, surface->atlas);
  surface->maps = bakeAtlas(facets, traits, surface->atlas, progress.part(0.8, 1));
  return surface;
}

}  // namespace sonoskin
