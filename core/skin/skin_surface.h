#pragma once

#include <limits>
#include <memory>

#include "core/mesh/atlas/atlas.h"
#include "core/mesh/atlas/atlas_maps.h"
#include "core/mesh/mesh.h"
#include "core/skin/diffusion_method.h"

namespace sonoskin {

// SkinQuality: what pictures of skin may cost.
//   triangles       the mesh is reduced to about so many; 0: all are kept
//   texel           mm of a body; larger and smaller objects are shown with larger and smaller ones, see `texels`
//   texels          at most in all, gaps between charts included: 150 bytes each while a picture is made. 4 million
//                   are enough for 0.15 mm on 270 cm² of skin, more than any scan shows, and for 0.3 mm on any head
//   skirt           mm: how much of the surface beyond a chart is drawn beside it for blurs to find: three widths of the
//                   widest blur make 8; 5 cost 0.0005 of its red on average          [theory/skin.md, 3.2, step 6]
//   shadowSize      texels along the side of each light's depth map, at most: twice as fine as the atlas is enough
//   shadowTaps      looks into it per texel
//   detailLayers    of pores and lines, 0 to 2
//   diffusion       by whom light is spread, at least: an atlas that cannot be blurred has it from point to point
//   ownCoordinates  whether a mesh's own texture coordinates are used, where it has any and they are good enough; where
//                   not, the log says so
struct SkinQuality {
  int triangles = 0;
  double texel = 0.15;
  double texels = 1.25e7;
  double skirt = 8;
  int shadowSize = 2048;
  int shadowTaps = 32;
  int detailLayers = 2;
  DiffusionMethod diffusion = DiffusionMethod::blurs;
  bool ownCoordinates = false;
};

// fullQuality: for graphics cards; lightQuality: for software renderers; pictureQuality: for finished pictures.
SkinQuality fullQuality();
SkinQuality pictureQuality();
SkinQuality lightQuality();

// SkinSight: what a picture shows of a surface.
//   viewProjection  world mm -> clip space
//   size            of the picture in samples; {0, 0}: everything is shown, from all around
//   reach           mm: how far light spreads
//   sample          mm from one sample to the next where the surface is nearest; 0: unknown
struct SkinSight {
  glm::mat4 viewProjection{1};
  glm::ivec2 size{0};
  float reach = 0;
  float sample = 0;

  bool isAll() const { return size.x == 0; }
};

// SkinSurface: a mesh made ready to be shown as skin.
//   mesh         what is drawn: reduced if the quality asks for it
//   shown        of a picture, how many of its triangles it shows: the first ones; light spreads from the others to them
//   hidden       the rest, without triangles where there is none: it casts shadows and hides the sky
//   check        as checkOverlap
//   atlas        charts; blocks where the check fails (pointBased is true then)
//   maps         without what only the GPU reads once keepForLight() was asked for
struct SkinSurface {
  std::shared_ptr<const Mesh> mesh;
  std::size_t shown = std::numeric_limits<std::size_t>::max();
  Mesh hidden;
  Atlas atlas;
  AtlasCheck check;
  AtlasVertices vertices;
  AtlasMaps maps;
  bool pointBased = false;

  // keepForLight: gives the memory of normals, open sky and stretch back, once they are on the GPU: half of the maps'.
  // What spreads light from point to point needs the others alone.
  void keepForLight();
};

// prepareSkin: everything about a surface that light and, unless there is a sight, the camera do not change.
//   input   mesh   world mm, with normals
//           front  unit, toward the home view's eye
//           sight  of a finished picture: what it does not show is neither charted nor baked, and texels are no smaller than
//                  its samples
//   cost    0.5 M triangles in full quality: about 2 s on two cores
//   errors  Error: no triangles; Cancelled
std::shared_ptr<SkinSurface> prepareSkin(std::shared_ptr<const Mesh> mesh, const glm::vec3& front,
                                         const SkinQuality& quality, const SkinSight& sight,
                                         const Progress& progress = {});
inline std::shared_ptr<SkinSurface> prepareSkin(std::shared_ptr<const Mesh> mesh, const glm::vec3& front,
                                                const SkinQuality& quality, const Progress& progress = {}) {
  return prepareSkin(std::move(mesh), front, quality, SkinSight{}, progress);
}

}  // namespace sonoskin
