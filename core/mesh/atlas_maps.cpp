#include "core/mesh/atlas_maps.h"

#include <limits>

#include "core/base/error.h"
#include "core/mesh/atlas_rim.h"
#include "core/mesh/atlas_stretch.h"

namespace sonoskin {
namespace {

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

// Baker: writes texels of the maps from triangles of the mesh.
struct Baker {
  const Mesh& mesh;
  const SurfaceTraits& traits;
  AtlasMaps& maps;

  std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(maps.size.x) + std::size_t(x); }

  // hides: whether what an owned texel shows lies elsewhere and under a more open sky than a triangle that claims it,
  // too: then it is the outer one of two sheets.
  bool hides(std::size_t texel, std::uint32_t triangle, const glm::vec3& w) const {
    constexpr float kSamePlace = 0.3f;  // mm
    const glm::vec4& shown = maps.position[texel];
    if (shown.w < 1) return false;
    const auto& [i, j, k] = mesh.triangles[triangle];
    const glm::vec3 place = w.x * mesh.positions[i] + w.y * mesh.positions[j] + w.z * mesh.positions[k];
    const float open =
        w.x * traits.occlusion[i].w + w.y * traits.occlusion[j].w + w.z * traits.occlusion[k].w;
    return glm::length(place - glm::vec3(shown)) > kSamePlace && maps.occlusion[texel].w > open;
  }
  void write(std::size_t texel, std::uint32_t triangle, const glm::vec3& w, float coverage) const {
    const auto& [i, j, k] = mesh.triangles[triangle];
    const auto mix = [&](const auto& of) { return w.x * of[i] + w.y * of[j] + w.z * of[k]; };
    maps.position[texel] = glm::vec4(mix(mesh.positions), coverage);
    const glm::vec3 normal = unitOr(mix(mesh.normals), mesh.normals[i]);
    maps.normal[texel] = glm::vec4(normal, mix(traits.curvature));
    const glm::vec4 sky = mix(traits.occlusion);
    maps.occlusion[texel] = glm::vec4(unitOr(glm::vec3(sky), normal), std::clamp(sky.w, 0.f, 1.f));
  }
};

// Triangles in the order in which they are drawn: what comes later is seen.
struct DrawList {
  std::vector<std::uint32_t> triangles;
  std::vector<Corners> corners;
};

// Skirts, then owners that are turned over, then the others.
DrawList drawOrder(const Atlas& atlas, std::size_t& firstOwner) {
  DrawList list{atlas.skirts, atlas.skirtCorners};
  firstOwner = list.triangles.size();
  for (const bool turned : {true, false})
    for (std::uint32_t t = 0; t < atlas.corners.size(); ++t) {
      if ((Barycentric(atlas.corners[t]).area < 0) != turned) continue;
      list.triangles.push_back(t);
      list.corners.push_back(atlas.corners[t]);
    }
  return list;
}

void drawTriangles(const Baker& baker, const Atlas& atlas, const Progress& progress) {
  std::size_t firstOwner = 0;
  const DrawList list = drawOrder(atlas, firstOwner);
  const AtlasBands bands(atlas.size, list.corners);
  parallelFor(
      bands.count(),
      [&](std::ptrdiff_t b) {
        const int band = int(b);
        for (const std::uint32_t* i = bands.begin(band); i != bands.end(band); ++i) {
          const float coverage = *i < firstOwner ? 0.5f : 1.f;
          forEachTexel(list.corners[*i], atlas.size.x, bands.rows(band),
                       [&](int x, int y, const glm::vec3& w) {
                         const std::size_t texel = baker.index(x, y);
                         if (!baker.hides(texel, list.triangles[*i], w))
                           baker.write(texel, list.triangles[*i], w, coverage);
                       });
        }
      },
      progress);
}

// The position where a triangle's plane goes on beyond a point of its side; at most a few texels away from it, for steep
// triangles go far.
glm::vec3 goOn(const Mesh& mesh, const Triangle& triangle, const Barycentric& plane, const glm::vec2& texel,
               const glm::vec3& onSide, float farthest) {
  if (!plane.valid()) return onSide;
  const glm::vec3 w = plane.at(texel);
  const glm::vec3 beyond = w.x * mesh.positions[triangle[0]] + w.y * mesh.positions[triangle[1]] +
                           w.z * mesh.positions[triangle[2]] - onSide;
  const float way = glm::length(beyond);
  return way < farthest ? onSide + beyond : onSide + beyond * (farthest / way);
}

// The surface just beyond the ends of charts, where nothing is drawn yet.
void drawRims(const Baker& baker, const Atlas& atlas, const Facets& facets, const Progress& progress) {
  constexpr float kFarthest = 5;  // texels
  const std::vector<RimSide> sides = rimSides(facets, atlas);
  std::vector<Corners> corners;
  for (const RimSide& side : sides) corners.push_back(atlas.corners[side.triangle]);
  const AtlasBands bands(atlas.size, corners, kRimReach);
  parallelFor(
      bands.count(),
      [&](std::ptrdiff_t b) {
        const glm::ivec2 rows = bands.rows(int(b));
        const std::size_t first = baker.index(0, rows[0]), last = baker.index(0, rows[1]);
        std::vector<float> nearest;
        for (std::size_t i = first; i < last; ++i)
          nearest.push_back(baker.maps.position[i].w > 0 ? -1 : std::numeric_limits<float>::max());
        for (const std::uint32_t* i = bands.begin(int(b)); i != bands.end(int(b)); ++i) {
          const RimSide& side = sides[*i];
          const Barycentric plane(corners[*i]);
          forEachRimTexel(corners[*i], side.corner, atlas.size.x, rows,
                          [&](int x, int y, float distance, const glm::vec3& w) {
                            const std::size_t texel = baker.index(x, y);
                            if (distance >= nearest[texel - first]) return;
                            nearest[texel - first] = distance;
                            baker.write(texel, side.triangle, w, 0.5f);
                            glm::vec4& position = baker.maps.position[texel];
                            const glm::vec2 centre(float(x) + 0.5f, float(y) + 0.5f);
                            position = glm::vec4(goOn(baker.mesh, baker.mesh.triangles[side.triangle], plane,
                                                      centre, glm::vec3(position), kFarthest * atlas.texel),
                                                 0.5f);
                          });
        }
      },
      progress);
}

}  // namespace

AtlasMaps bakeAtlas(const Mesh& mesh, const SurfaceTraits& traits, const Atlas& atlas,
                    const Progress& progress) {
  const std::size_t vertices = mesh.positions.size();
  require(mesh.normals.size() == vertices && traits.occlusion.size() == vertices &&
              traits.curvature.size() == vertices,
          "A surface needs normals, occlusion and curvature of every vertex before it is baked.");
  require(atlas.corners.size() == mesh.triangles.size(), "The atlas belongs to another mesh.");
  const std::size_t texels = std::size_t(atlas.size.x) * std::size_t(atlas.size.y);
  AtlasMaps maps{atlas.size,
                 std::vector<glm::vec4>(texels, glm::vec4(0)),
                 std::vector<glm::vec4>(texels, glm::vec4(0)),
                 std::vector<glm::vec4>(texels, glm::vec4(0)),
                 {}};
  const Baker baker{mesh, traits, maps};
  drawTriangles(baker, atlas, progress.part(0, 0.5));
  drawRims(baker, atlas, Facets(mesh), progress.part(0.5, 0.6));
  maps.stretch = stretchMap(atlas.size, maps.position, atlas.texel, progress.part(0.6, 1));
  return maps;
}

}  // namespace sonoskin
