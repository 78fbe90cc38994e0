#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/facets.h"

namespace sonoskin {

// Corners: where a triangle's three corners lie in an atlas, in texels from the lower left corner of texel (0,0).
using Corners = std::array<glm::vec2, 3>;

// Atlas: a flat map of a surface.
//   chart      per triangle: the number of its chart
//   corners    per triangle
//   skirts     triangles that are drawn again beside another chart, so that a blur finds there what lies beside it on
//              the surface; skirtCorners, skirtChart: where and for which chart. Owners are drawn over skirts.
struct Atlas {
  glm::ivec2 size{0};   // texels
  float texel = 0.15f;  // mm per texel where a chart faces its axis
  float unit = 1;       // of AtlasOptions
  int charts = 0;
  std::vector<std::uint32_t> chart;
  std::vector<Corners> corners;
  std::vector<std::uint32_t> skirts, skirtChart;
  std::vector<Corners> skirtCorners;
};

// AtlasOptions: lengths in mm.
struct AtlasOptions {
  double texel = 0.15;
  double skirt = 8;           // what blurs may find beyond a chart
  double normalLength = 0.5;  // normals are smoothed over this before charts are chosen
  glm::vec3 front{0, 0, 1};   // unit; the chart that looks this way is favoured
  int maxSize = 8192;         // texels a side; a larger atlas gets larger texels
  double maxTexels = 6.8e7;   // in all, gaps included; so does one that has more
  double unit = 1;            // how many times as large as a body's folds, charts and noise are taken to be
  // Triangles: charts of later ones have kCoarser times the texel and no skirts.
  std::size_t fine = std::numeric_limits<std::size_t>::max();
};

inline constexpr float kCoarser = 3;

// buildAtlas: charts by parallel projection along 14 axes, of which one is `front`.
//   method   theory/skin.md, 3.2
//   cost     1 million triangles: below 2 s on two cores
//   errors   Error: the options leave a texel or an atlas no size; Cancelled
Atlas buildAtlas(const Facets& facets, const AtlasOptions& options, const Progress& progress = {});
Atlas buildAtlas(const Mesh& mesh, const AtlasOptions& options, const Progress& progress = {});

// atlasFromCoordinates: charts as the mesh's own texture coordinates have them, at a size at which the middle one of its
// triangles has options.texel mm per texel. Without skirts: beside a chart is nothing.
//   output   nothing where the mesh has no coordinates, or where more than 0.01 of their picture is used twice
std::optional<Atlas> atlasFromCoordinates(const Mesh& mesh, const AtlasOptions& options);

// blockAtlas: every triangle gets a small block of its own. Works for any mesh and has no overlap, but nothing lies
// beside its neighbours: for point-based diffusion only.
//   maxTexels  in all; more only where even the smallest blocks have more
//   errors     Error: the smallest blocks need more than maxSize a side
Atlas blockAtlas(const Mesh& mesh, double texel, int maxSize, double maxTexels = 6.8e7);

// AtlasCheck: what texture diffusion needs to know about an atlas.
//   overlap    share of the owned texels that two triangles of one chart claim at different depths
//   uncovered  share of the area of triangles that no owned texel shows
//   area       mm^2, of an object brought to the size of a body by the atlas' unit
//   steep      share of the area whose triangles are stretched more than 1 / 0.3
//   stretch    largest and 99th percentile of mm per texel, over the nominal one
//   errors     Error: the atlas belongs to another mesh
struct AtlasCheck {
  int charts = 0;
  double overlap = 0, uncovered = 0, steep = 0, stretch99 = 1, stretchMax = 1;
  double seamLength = 0;  // mm
  double area = 0;
  bool flat() const { return overlap <= 0.01; }
  // good: whether light may be diffused in it.               [theory/skin.md, 3.1: 60 charts; more for large heads: ours]
  bool good() const { return flat() && charts <= 60 + area / 100; }
};
AtlasCheck checkAtlas(const Facets& facets, const Atlas& atlas);
AtlasCheck checkAtlas(const Mesh& mesh, const Atlas& atlas);
// checkOverlap: of all this what good() asks for: charts, overlap and area; in half of the time.
AtlasCheck checkOverlap(const Facets& facets, const Atlas& atlas);

// AtlasVertices: the mesh with vertices of their own on both sides of a seam, to be drawn with the atlas' maps.
//   uv      0 to 1 over the atlas
//   source  per vertex: the vertex of the mesh
//   errors  Error: the atlas belongs to another mesh
struct AtlasVertices {
  std::vector<glm::vec2> uv;
  std::vector<std::uint32_t> source;
  std::vector<Triangle> triangles;
};
AtlasVertices splitAtSeams(const Mesh& mesh, const Atlas& atlas);

}  // namespace sonoskin
