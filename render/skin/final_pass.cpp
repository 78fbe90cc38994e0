#include "render/skin/final_pass.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <cmath>

#include "render/lighting.h"
#include "render/skin/gpu_skin.h"
#include "render/surface_shading.h"

namespace sonoskin {
namespace {

// How shaders/skin/final.frag is compiled for a pass; -1: map.frag shows it.
int finalVariant(SkinPass pass) {
  switch (pass) {
    case SkinPass::skin:
      return 0;
    case SkinPass::undiffused:
      return 1;
    case SkinPass::diffused:
      return 2;
    case SkinPass::specular:
      return 3;
    default:
      return -1;
  }
}

// What the inner sides of an open surface show: dark flesh in even light, whatever reaches the other side.
glm::vec3 insideColour(const LightRig& lights) {
  glm::vec3 reaching = 0.282095f * lights.environment[0];
  for (const SkinLight& light : lights.lights) reaching += 0.12f * light.colour;
  return glm::vec3(0.20f, 0.095f, 0.07f) * reaching;
}

// Which level of spread light a pass shows; 0: none, or the irradiance.
int levelShown(SkinPass pass) {
  const bool isLevel = pass >= SkinPass::blur1 && pass <= SkinPass::blur5;
  return isLevel ? 1 + int(pass) - int(SkinPass::blur1) : 0;
}

// ShownMap: a map and how map.frag turns it into colours.
struct ShownMap {
  const gl::Texture* texture = nullptr;
  int kind = 0, channel = 0;
  float scale = 1;
};

ShownMap shownMap(const SkinViewInput& input, const LightPasses& light, const gl::Texture& charts) {
  const GpuSkin::Parts& parts = input.surface.parts();
  const float exposure = input.look.lights.exposure;
  switch (input.pass) {
    case SkinPass::blur1:
    case SkinPass::blur2:
    case SkinPass::blur3:
    case SkinPass::blur4:
    case SkinPass::blur5:
      return {&light.diffuser().level(levelShown(input.pass)), 0, 0, exposure};
    case SkinPass::through:
      return {&light.diffuser().through(), 0, 0, exposure};
    case SkinPass::albedo:
      return {&light.entering().albedo(), 1, 0, 1};
    case SkinPass::finish:
      return {&light.entering().finish(), 1, 0, 1};
    case SkinPass::shadow:
      return {&light.entering().visibility(), 2, 0, 1};
    case SkinPass::occlusion:
      return {&parts.open, 2, 3, 1};
    case SkinPass::normal:
      return {&parts.normal, 3, 0, 1};
    case SkinPass::curvature:
      return {&parts.normal, 4, 3, 4};
    case SkinPass::stretch:
      return {&parts.stretch, 5, 0, 1 / parts.surface->atlas.texel};
    case SkinPass::charts:
      return {&charts, 6, 0, 1};
    default:
      return {&light.diffuser().level(0), 0, 0, exposure};
  }
}

PixelRect shownColumns(glm::ivec2 size, glm::vec2 share) {
  const glm::ivec2 columns(glm::round(share * float(size.x)));
  return {{columns.x, 0}, {columns.y, size.y}};
}

// Where a box of the world can be seen: a software renderer runs shaders on all pixels of a draw, empty or not.
PixelRect pixelsOf(const Box& box, const glm::mat4& viewProjection, glm::ivec2 size) {
  glm::vec2 least(1), most(-1);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::bvec3 far(corner & 1, corner & 2, corner & 4);
    const glm::vec4 seen = viewProjection * glm::vec4(glm::mix(box.min, box.max, far), 1);
    if (seen.w <= 0) return {{0, 0}, size};
    least = glm::min(least, glm::vec2(seen) / seen.w);
    most = glm::max(most, glm::vec2(seen) / seen.w);
  }
  const glm::vec2 scale = 0.5f * glm::vec2(size);
  return {glm::max(glm::ivec2(glm::floor((least + 1.f) * scale)), glm::ivec2(0)),
          glm::min(glm::ivec2(glm::ceil((most + 1.f) * scale)), size)};
}

// Draws go to a part of the target alone.
void cutTo(const PixelRect& part, glm::ivec2 corner = {0, 0}) {
  const glm::ivec2 size = glm::max(part.end - part.first, glm::ivec2(0));
  glEnable(GL_SCISSOR_TEST);
  glScissor(corner.x + part.first.x, corner.y + part.first.y, size.x, size.y);
}

constexpr int kBandRows = 160;  // of a picture, whose samples are drawn at a time

}  // namespace

bool showsMap(SkinPass pass) { return finalVariant(pass) < 0; }

void FinalPass::Canvas::bind(const gl::Framebuffer& to, glm::ivec2 first) const {
  to.bind();
  glViewport(-first.x, -first.y, size.x, size.y);
}

FinalPass::FinalPass()
    : surfaceProgram_({"skin/surface.vert", "skin/surface.frag"}),
      surface_(surfaceTexels({gl::Format::rg16})),
      samples_({.size = {1, 1}, .colours = {gl::Format::rgba16f}}),
      backdrop_({.size = {1, 1}}),
      detail_(makeDetailTile()),
      specularTable_(specularTexture()) {}

void FinalPass::setBackdrop(gl::Program& program, const Backdrop& backdrop) {
  program.set("backgroundTop", backdrop.top);
  program.set("backgroundBottom", backdrop.bottom);
  program.set("backdrop", backdrop.shown ? 1.0f : 0.0f);
}

void FinalPass::copyBackdrop(const Backdrop& backdrop, const gl::Target& to, glm::vec2 shownPart) {
  if (backdrop != backdropOf_) {
    backdrop_.fit(backdrop.size);
    backdrop_.bind();
    glDisable(GL_SCISSOR_TEST);
    gl::Program& p = programs_.use("skin/background.frag", {});
    setBackdrop(p, backdrop);
    gl::drawFullScreen();
    backdropOf_ = backdrop;
  }
  const PixelRect part = shownColumns(to.size, shownPart);
  const glm::ivec2 first = to.corner + part.first, end = to.corner + part.end;
  glDisable(GL_SCISSOR_TEST);
  glBlitNamedFramebuffer(backdrop_.name(), to.framebuffer, part.first.x, part.first.y, part.end.x, part.end.y,
                         first.x, first.y, end.x, end.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void FinalPass::drawSurface(const SkinViewInput& input, const Canvas& canvas) {
  const PixelRect& kept = canvas.kept;
  surface_.fit(glm::max(kept.end - kept.first, glm::ivec2(1)));
  surface_.clearDepth();  // what is read of the colours has been drawn
  canvas.bind(surface_, kept.first);
  cutTo({canvas.part.first - kept.first, canvas.part.end - kept.first});
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  surfaceProgram_.use();
  surfaceProgram_.set("viewProjection", canvas.projection * input.camera.view());
  const ClipInUse clipped(surfaceProgram_, input.clip);
  input.surface.parts().draw();
}

void FinalPass::shade(const SkinViewInput& input, const LightPasses& light, const Canvas& canvas,
                      glm::ivec2 first) {
  const EnteringLight& entering = light.entering();
  const SpreadLight spread = light.diffuser().result();
  std::vector<std::string> defines{
      kindDefine(input.look.lights),
      fmt::format("DETAIL {}", input.look.skin.detail > 0 ? input.quality.detailLayers : 0),
      fmt::format("PASS {}", finalVariant(input.pass))};
  defines.push_back(fmt::format("LOBES {}", input.quality.detailLayers > 1 ? 2 : 1));
  if (input.look.skin.wetness > 0) defines.emplace_back("WET");
  if (input.supersampling > 1) defines.emplace_back("LINEAR");
  gl::Program& p = programs_.use("skin/final.frag", defines);
  bindTo(p, "surfaceMap", 0, surface_.colour(0));
  bindTo(p, "placeMap", 1, surface_.colour(1));
  bindTo(p, "depthMap", 2, surface_.depth());
  bindTo(p, "diffusedMap", 3, spread.map);
  bindTo(p, "visibilityMap", 4, entering.visibility());
  bindTo(p, "albedoMap", 5, entering.albedo());
  bindTo(p, "finishMap", 6, entering.finish());
  bindTo(p, "specularTable", 7, specularTable_);
  bindTo(p, "detailTile", 8, detail_.texture);
  p.set("tileLength", DetailTile::kLength);
  // The second layer is the tile made larger; its slopes stay the same.
  p.set("lostSlope", glm::vec2(detail_.meanSlope));
  p.set("detail", float(input.look.skin.detail));
  p.set("toSurface", first - canvas.kept.first);
  p.set("pixelLength", input.camera.millimetresPerPixel(canvas.size.y) / input.camera.distance);
  p.set("mixBefore", float(input.look.skin.mix));
  p.set("exposure", input.look.lights.exposure);
  p.set("firstWeight", spread.firstWeight);
  p.set("unseenShade", input.unseenShade);
  p.set("insideColour", insideColour(input.look.lights));
  entering.lightMaps().setLights(p, input.look.lights);
  setScreen(p, input.camera, float(canvas.size.x) / float(canvas.size.y), canvas.projection);
  gl::drawFullScreen();
}

void FinalPass::showMap(const SkinViewInput& input, const LightPasses& light, glm::ivec2 toSurface) {
  const GpuSkin::Parts& parts = input.surface.parts();
  if (input.pass == SkinPass::charts && chartsOf_ != parts.number) {
    charts_ = chartNumbers(*parts.surface);
    chartsOf_ = parts.number;
  }
  const ShownMap shown = shownMap(input, light, charts_);
  std::vector<std::string> defines{fmt::format("MAP {}", shown.kind)};
  if (input.supersampling > 1) defines.emplace_back("LINEAR");
  gl::Program& p = programs_.use("skin/map.frag", defines);
  bindTo(p, "surfaceMap", 0, surface_.colour(0));
  bindTo(p, "placeMap", 1, surface_.colour(1));
  bindTo(p, "depthMap", 2, surface_.depth());
  bindTo(p, "map", 3, *shown.texture);
  p.set("toSurface", toSurface);
  p.set("channel", shown.channel);
  p.set("scale", shown.scale);
  gl::drawFullScreen();
}

void FinalPass::draw(const SkinViewInput& input, LightPasses& light, const gl::Target& target) {
  Canvas canvas{target.size * input.supersampling,
                input.camera.projection(float(target.size.x) / float(target.size.y), input.surface.box())};
  const PixelRect columns = shownColumns(canvas.size, input.shownPart);
  canvas.part = pixelsOf(input.surface.box(), canvas.projection * input.camera.view(), canvas.size);
  canvas.part.first = glm::max(canvas.part.first, columns.first);
  canvas.part.end = glm::min(canvas.part.end, columns.end);
  // Buffers that follow the mouse keep their size.
  canvas.kept = input.supersampling > 1 ? canvas.part : PixelRect{{0, 0}, canvas.size};
  // Some maps are drawn when they are looked at: before the target is bound.
  if (input.pass == SkinPass::through) light.drawThrough(input.surface);
  if (const int level = levelShown(input.pass)) light.drawLevel(input.surface, level);
  drawSurface(input, canvas);
  const Lighting studio = portraitLighting(input.camera);
  const Backdrop backdrop{canvas.size, studio.backgroundTop, studio.backgroundBottom, input.background};
  if (input.supersampling > 1) {
    drawInBands(input, light, canvas, backdrop, target);
    return;
  }
  copyBackdrop(backdrop, target, input.shownPart);
  target.bind();
  cutTo(canvas.part, target.corner);
  colour(input, light, canvas, -target.corner);
}

void FinalPass::colour(const SkinViewInput& input, const LightPasses& light, const Canvas& canvas,
                       glm::ivec2 first) {
  if (showsMap(input.pass))
    showMap(input, light, first - canvas.kept.first);
  else
    shade(input, light, canvas, first);
}

// All samples of a picture at once would take more memory than the skin.
void FinalPass::drawInBands(const SkinViewInput& input, const LightPasses& light, const Canvas& canvas,
                            const Backdrop& backdrop, const gl::Target& target) {
  const glm::mat4 viewProjection = canvas.projection * input.camera.view();
  const gl::Texture& outline =
      outline_.draw(canvas.size, viewProjection, input.clip, [&] { input.surface.parts().draw(); });
  const int rows = kBandRows * input.supersampling;
  samples_.fit({canvas.size.x, std::min(rows, canvas.size.y)});
  for (int first = 0; first < canvas.size.y; first += rows) {
    const PixelRect band{{canvas.part.first.x, std::max(canvas.part.first.y - first, 0)},
                         {canvas.part.end.x, std::min(canvas.part.end.y - first, samples_.size().y)}};
    samples_.clear({});
    canvas.bind(samples_, {0, first});
    cutTo(band);
    colour(input, light, canvas, {0, first});
    resolve(input, backdrop, outline, first / input.supersampling, target);
  }
}

void FinalPass::resolve(const SkinViewInput& input, const Backdrop& backdrop, const gl::Texture& outline,
                        int firstRow, const gl::Target& target) {
  target.bind();
  PixelRect part = shownColumns(target.size, input.shownPart);
  part.first.y = firstRow;
  part.end.y = std::min(firstRow + kBandRows, target.size.y);
  cutTo(part, target.corner);
  gl::Program& p = programs_.use("skin/resolve.frag", {});
  bindTo(p, "samples", 0, samples_.colour());
  bindTo(p, "outlineMap", 1, outline);
  p.set("perSide", input.supersampling);
  p.set("firstRow", firstRow);
  setBackdrop(p, backdrop);
  gl::drawFullScreen();
}

}  // namespace sonoskin
