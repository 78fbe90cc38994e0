#include "core/skin/skin_surface.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/log.h"
#include "core/mesh/repair/decimate.h"

namespace sonoskin {
namespace {

constexpr int kMaxSize = 8192;  // texels a side

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
void findAtlas(const AtlasOptions& options, bool ownCoordinates, SkinSurface& surface,
               const Progress& progress) {
  const Mesh& mesh = *surface.mesh;
  if (std::optional<Atlas> own = ownCoordinates ? atlasFromCoordinates(mesh, options) : std::nullopt) {
    surface.check = checkAtlas(mesh, *own);
    surface.atlas = std::move(*own);
    if (surface.check.good()) return;
  }
  if (ownCoordinates)
    log(LogLevel::warning,
        "The surface brings no texture coordinates, or they show parts of it on top of each other; "
        "a map is made for it instead.");
  surface.atlas = buildAtlas(mesh, options, progress.part(0, 0.8));
  surface.check = checkAtlas(mesh, surface.atlas);
  surface.pointBased =
      !surface.check.good() || std::max(surface.atlas.size.x, surface.atlas.size.y) > options.maxSize;
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
  quality.skirt = 4.5;  // only depths are blurred, by 1.41 mm at most
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
                                         const SkinQuality& quality, const Progress& progress) {
  require(mesh && !mesh->empty(), "There is no surface to show as skin.");
  auto surface = std::make_shared<SkinSurface>();
  surface->mesh = reduced(std::move(mesh), quality.triangles, progress.part(0, 0.2));
  const SurfaceTraits traits = measureTraits(*surface->mesh, 128, 2, progress.part(0.2, 0.5));
  AtlasOptions options;
  options.texel = texelFor(surfaceArea(*surface->mesh), quality);
  options.unit = options.texel / quality.texel;
  options.maxTexels = quality.texels;
  options.skirt = quality.skirt;
  options.front = front;
  options.maxSize = kMaxSize;
  findAtlas(options, quality.ownCoordinates, *surface, progress.part(0.5, 0.8));
  surface->vertices = splitAtSeams(*surface->mesh, surface->atlas);
  surface->maps = bakeAtlas(*surface->mesh, traits, surface->atlas, progress.part(0.8, 1));
  return surface;
}

}  // namespace sonoskin
