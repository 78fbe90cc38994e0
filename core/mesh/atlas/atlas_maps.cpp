#include "core/mesh/atlas/atlas_maps.h"

#include <algorithm>
#include <limits>

#include "core/base/error.h"
#include "core/mesh/atlas/atlas_rim.h"
#include "core/mesh/atlas/atlas_stretch.h"

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
  float unit = 1;  // of the atlas

  std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(maps.size.x) + std::size_t(x); }

  // hides: whether what an owned texel shows lies elsewhere and under a more open sky than a triangle that claims it,
  // too: then it is the outer one of two sheets.
  bool hides(std::size_t texel, std::uint32_t triangle, const glm::vec3& w) const {
    constexpr float kSamePlace = 0.3f;  // mm of a body
    const glm::vec4& shown = maps.position[texel];
    if (shown.w < 1) return false;
    const auto& [i, j, k] = mesh.triangles[triangle];
    const glm::vec3 place = w.x * mesh.positions[i] + w.y * mesh.positions[j] + w.z * mesh.positions[k];
    const float open =
        w.x * traits.occlusion[i].w + w.y * traits.occlusion[j].w + w.z * traits.occlusion[k].w;
    return glm::length(place - glm::vec3(shown)) > kSamePlace * unit && maps.occlusion[texel].w > open;
  }
  void write(std::size_t texel, std::uint32_t triangle, const glm::vec3& w, float coverage) const {
    const auto& [i, j, k] = mesh.triangles[triangle];
    const auto mix = [&](const auto& of) { return w.x * of[i] + w.y * of[j] + w.z * of[k]; };
    maps.triangle[texel] = triangle;
    maps.position[texel] = glm::vec4(mix(mesh.positions), coverage);
    const glm::vec3 normal = unitOr(mix(mesh.normals), mesh.normals[i]);
    maps.normal[texel] = glm::vec4(normal, mix(traits.curvature));
    const glm::vec4 sky = mix(traits.occlusion);
    maps.occlusion[texel] = glm::vec4(unitOr(glm::vec3(sky), normal), std::clamp(sky.w, 0.f, 1.f));
  }

  // continues: whether a texel of skirt shows what lies beside a point of a triangle.
  bool continues(std::size_t texel, const glm::vec3& point, const glm::vec3& normal, float farthest) const {
    return glm::distance(glm::vec3(maps.position[texel]), point) < farthest &&
           glm::dot(glm::vec3(maps.normal[texel]), normal) > 0.1f;
  }
  // goOn: a texel beyond a triangle's side gets the triangle's plane, unless the surface itself goes on there. At most a
  // few texels away from the side, for steep triangles go far.
  //   onSide   weights of the nearest point of the side
  void goOn(std::size_t texel, std::uint32_t triangle, const Corners& corners, const glm::vec3& onSide,
            float texelSize) const {
    constexpr float kFarthest = 5, kFarthestSkirt = 7;  // texels
    if (maps.position[texel].w == 1) return;
    const auto& [i, j, k] = mesh.triangles[triangle];
    const auto mix = [&](const std::vector<glm::vec3>& of, const glm::vec3& w) {
      return w.x * of[i] + w.y * of[j] + w.z * of[k];
    };
    const glm::vec3 side = mix(mesh.positions, onSide);
    if (maps.position[texel].w > 0 &&
        continues(texel, side, mix(mesh.normals, onSide), kFarthestSkirt * texelSize))
      return;
    write(texel, triangle, onSide, 0.5f);
    const Barycentric plane(corners);
    if (!plane.valid()) return;
    const auto width = std::size_t(maps.size.x);
    const glm::vec2 middle(float(texel % width) + 0.5f, float(texel / width) + 0.5f);
    const glm::vec3 beyond = mix(mesh.positions, plane.at(middle)) - side;
    const float way = glm::length(beyond), farthest = kFarthest * texelSize;
    maps.position[texel] = glm::vec4(side + (way < farthest ? 1 : farthest / way) * beyond, 0.5f);
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

// The side whose rim reaches nearest to a texel.
struct NearestSide {
  float distance = std::numeric_limits<float>::max();
  const RimSide* side = nullptr;
  glm::vec3 weights{0};
};

// The surface just beyond the ends of charts, where nothing is drawn yet, or a skirt that shows another place.
void drawRims(const Baker& baker, const Atlas& atlas, const Facets& facets, const Progress& progress) {
  const std::vector<RimSide> sides = rimSides(facets, atlas);
  std::vector<Corners> corners;
  for (const RimSide& side : sides) corners.push_back(atlas.corners[side.triangle]);
  const AtlasBands bands(atlas.size, corners, kRimReach);
  parallelFor(
      bands.count(),
      [&](std::ptrdiff_t b) {
        const glm::ivec2 rows = bands.rows(int(b));
        const std::size_t first = baker.index(0, rows[0]);
        std::vector<NearestSide> nearest(baker.index(0, rows[1]) - first);
        for (const std::uint32_t* i = bands.begin(int(b)); i != bands.end(int(b)); ++i)
          forEachRimTexel(corners[*i], sides[*i].corner, atlas.size.x, rows,
                          [&](int x, int y, float distance, const glm::vec3& w) {
                            NearestSide& side = nearest[baker.index(x, y) - first];
                            if (distance < side.distance) side = {distance, &sides[*i], w};
                          });
        for (std::size_t n = 0; n < nearest.size(); ++n)
          if (nearest[n].side)
            baker.goOn(first + n, nearest[n].side->triangle, atlas.corners[nearest[n].side->triangle],
                       nearest[n].weights, atlas.texel);
      },
      progress);
}

}  // namespace

AtlasMaps bakeAtlas(const Mesh& mesh, const SurfaceTraits& traits, const Atlas& atlas,
                    const Progress& progress) {
  return bakeAtlas(Facets(mesh), traits, atlas, progress);
}

AtlasMaps bakeAtlas(const Facets& facets, const SurfaceTraits& traits, const Atlas& atlas,
                    const Progress& progress) {
  const Mesh& mesh = facets.mesh;
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
                 {},
                 std::vector<std::uint32_t>(texels, 0)};
  const Baker baker{mesh, traits, maps, atlas.unit};
  drawTriangles(baker, atlas, progress.part(0, 0.5));
  drawRims(baker, atlas, facets, progress.part(0.5, 0.6));
  maps.stretch = stretchMap(atlas, maps.position, progress.part(0.6, 1));
  return maps;
}

}  // namespace sonoskin
