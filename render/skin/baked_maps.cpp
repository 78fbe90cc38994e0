#include "render/skin/baked_maps.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/gl/read_pixels.h"
#include "render/skin/detail_tile.h"
#include "render/skin/gpu_skin.h"
#include "render/skin/light_passes.h"
#include "render/skin/pass_programs.h"
#include "render/surface_shading.h"

namespace sonoskin {
namespace {

constexpr double kSkirt =
    4.5;  // mm: coarser copies of the pictures, as viewers make them, read beyond charts

enum class BakedMap { colour, finish, normals, light };

// Baker: draws the maps of shaders/skin/bake.frag.
struct Baker {
  const GpuSkin& surface;
  const SkinLook& look;
  const SkinQuality& quality;
  SkinView view{};
  DetailTile detail = makeDetailTile();
  PassPrograms programs{"common/fullscreen.vert"};
  gl::Framebuffer target{{.size = {1, 1}}};

  Image draw(BakedMap map) {
    const GpuSkin::Parts& parts = surface.parts();
    const EnteringLight& entering = view.light().entering();
    const SpreadLight spread = view.light().diffuser().result();
    target.fit(parts.atlasSize());
    target.bind();
    const int layers = look.skin.detail > 0 ? quality.detailLayers : 0;
    gl::Program& p =
        programs.use("skin/bake.frag", {fmt::format("MAP {}", int(map)), fmt::format("DETAIL {}", layers)});
    bindTo(p, "positionMap", 0, parts.position);
    bindTo(p, "normalMap", 1, parts.normal);
    bindTo(p, "albedoMap", 2, entering.albedo());
    bindTo(p, "finishMap", 3, entering.finish());
    bindTo(p, "irradianceMap", 4, view.light().diffuser().level(0));
    bindTo(p, "diffusedMap", 5, spread.map);
    bindTo(p, "detailTile", 6, detail.texture);
    p.set("tileLength", DetailTile::kLength);
    p.set("lostSlope", glm::vec2(detail.meanSlope));
    p.set("detail", float(look.skin.detail));
    p.set("mixBefore", float(look.skin.mix));
    p.set("exposure", look.lights.exposure);
    p.set("firstWeight", spread.firstWeight);
    gl::drawFullScreen();
    return gl::readImage(target);
  }
};

// The vertices lie apart at the atlas' seams.
void takeVertices(const SkinSurface& surface, TexturedMesh& to) {
  const AtlasVertices& v = surface.vertices;
  to.uv = v.uv;
  to.mesh.triangles = v.triangles;
  for (const std::uint32_t source : v.source) {
    to.mesh.positions.push_back(surface.mesh->positions[source]);
    to.mesh.normals.push_back(surface.mesh->normals[source]);
  }
}

}  // namespace

TexturedMesh bakeSurface(const GpuSkin& surface, const SkinLook& look, const BakeOptions& bake) {
  Baker baker{surface, look, bake.quality};
  baker.view.relight(surface, look, bake.quality);
  TexturedMesh baked;
  baked.lit = bake.light;
  takeVertices(*surface.surface(), baked);
  baked.colour = baker.draw(bake.light ? BakedMap::light : BakedMap::colour);
  if (bake.light) return baked;
  baked.normals = baker.draw(BakedMap::normals);
  baked.finish = baker.draw(BakedMap::finish);
  return baked;
}

TexturedMesh bakeSkin(gl::Context& context, std::shared_ptr<const Mesh> mesh, const Parameters& parameters,
                      const BakeOptions& bake, const PictureOptions& options, const Progress& progress) {
  const Box box = boundingBox(mesh->positions);
  const HomeFrame home = homeFrame(parseCamera("probe", options.beam, box, 1));
  SkinQuality quality = bake.quality;
  quality.skirt = std::max(quality.skirt, kSkirt);
  const auto surface = prepareSkin(std::move(mesh), home.back, quality, progress.part(0, 0.8));
  context.makeCurrent();
  GpuSkin gpu;
  gpu.set(surface);
  surface->keepForLight();
  const SkinLook look{parameters.skin, parameters.landmarks, makeLightRig(parameters.light, home, box)};
  TexturedMesh baked = bakeSurface(gpu, look, bake);
  progress.update(1);
  return baked;
}

}  // namespace sonoskin
