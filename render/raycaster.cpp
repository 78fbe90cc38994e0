#include "render/raycaster.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sonoskin {
namespace {

constexpr int kLightCell = 4;  // voxels

// View: where rays start and go. World mm.
struct View {
  bool perspective = true;
  glm::vec3 eye, centre, right, up;
};

View viewOf(const Camera& camera, float aspect) {
  const float tangent = std::tan(0.5f * glm::radians(camera.fieldOfView));
  return {true, camera.eye(), camera.forward, camera.right() * tangent * aspect, camera.up * tangent};
}

View viewOf(const LightView& light) {
  return {false, light.centre + light.radius * light.toLight, -light.toLight, light.right * light.radius,
          light.up * light.radius};
}

// From voxel indices of the volume to places in the mask's texture, 0 to 1.
void setErased(gl::Program& program, const GpuMask& erased, const Geometry& volume) {
  const Geometry& mask = erased.geometry();
  const glm::dvec3 dims(mask.dims);
  erased.texture().bind(4);
  program.set("erased", 4);
  program.set("erasedScale", glm::vec3(volume.spacing / mask.spacing / dims));
  program.set("erasedOffset", glm::vec3((mask.toIndex(volume.origin) + 0.5) / dims));
}

// The uniforms of shaders/volume/ray.glsl.
void setRays(gl::Program& program, const RaycastInput& input, const View& view) {
  const Geometry& g = input.volume.geometry();
  const glm::mat3 toAxes(glm::transpose(g.direction));
  const auto toIndex = [&](const glm::vec3& world) { return toAxes * world / glm::vec3(g.spacing); };
  program.set("perspective", view.perspective ? 1.0f : 0.0f);
  program.set("eyeIndex", glm::vec3(g.toIndex(glm::dvec3(view.eye))));
  program.set("rayCentre", toIndex(view.centre));
  program.set("rayRight", toIndex(view.right));
  program.set("rayUp", toIndex(view.up));
  program.set("viewCentre", view.centre);
  program.set("viewRight", view.right);
  program.set("viewUp", view.up);
  program.set("dims", g.dims);
  const glm::vec3 last(g.dims - 1);
  program.set("boxMin", input.part.cropMin * last);
  program.set("boxMax", input.part.cropMax * last);
  const ClipPlane& clip = input.part.clip;
  program.set("clip", glm::vec4(glm::vec3(g.spacing) * (toAxes * clip.normal),
                                glm::dot(clip.normal, glm::vec3(g.origin)) + clip.offset));
  program.set("stepLength", float(g.minSpacing()));
  input.volume.bricks().bind(1);
  program.set("bricks", 1);
  if (input.erased && *input.erased) setErased(program, *input.erased, g);
}

void setValues(gl::Program& program, const RaycastInput& input) {
  const Geometry& g = input.volume.geometry();
  input.volume.values().bind(0);
  program.set("values", 0);
  program.set("iso", input.iso);
  program.set("gradientReach", input.gradientReach);
  const glm::mat3 axes(g.direction);
  const glm::vec3 spacing(g.spacing);
  program.set("gradientToWorld", glm::mat3(axes[0] / spacing.x, axes[1] / spacing.y, axes[2] / spacing.z));
}

Hasher& addTransfer(Hasher& hasher, const TransferFunction& transfer) {
  for (const auto& p : transfer.points)
    hasher.add(p.value).add(p.opacity).add(p.colour.x).add(p.colour.y).add(p.colour.z);
  return hasher;
}

Hasher& addVector(Hasher& hasher, const glm::vec3& v) { return hasher.add(v.x).add(v.y).add(v.z); }

Key extinctionKeyOf(const RaycastInput& input) {
  Hasher hasher("extinction");
  addTransfer(hasher.add(input.volume.number()), input.transfer);
  const ShownPart& part = input.part;
  for (const glm::vec3& v : {part.cropMin, part.cropMax, part.clip.normal}) addVector(hasher, v);
  return hasher.add(part.clip.offset).key();
}

// How many of the layers that a transfer function's opacity means one step of a ray passes.
float stepLayers(const Geometry& g) { return float(g.minSpacing() * 250 / worldDiagonal(g)); }

// Light that has travelled through tissue comes out redder.
std::array<glm::u8vec4, 256> tints() {
  std::array<glm::u8vec4, 256> table;
  for (int i = 0; i < 256; ++i) {
    const float share = float(i) / 255;
    table[std::size_t(i)] =
        255.0f * glm::vec4(std::pow(share, 0.7f), share, std::pow(share, 1.25f), share) + 0.5f;
  }
  return table;
}

gl::Texture lightTexture(const Volume<float>& light) {
  static const std::array<glm::u8vec4, 256> table = tints();
  std::vector<glm::u8vec4> texels;
  texels.reserve(light.data.size());
  for (const float share : light.data) texels.push_back(table[std::size_t(255 * share + 0.5f)]);
  gl::Texture texture({.size = light.geometry.dims, .format = gl::Format::rgba8});
  texture.upload(texels.data());
  return texture;
}

glm::ivec2 scaled(glm::ivec2 size, float factor) {
  return glm::max(glm::ivec2(glm::round(glm::vec2(size) * factor)), glm::ivec2(1));
}

// Draws go to a part of the rows alone.
void bindRows(const gl::Framebuffer& to, const glm::vec2& rows) {
  to.bind();
  const auto first = int(std::lround(rows.x * float(to.size().y))),
             end = int(std::lround(rows.y * float(to.size().y)));
  glScissor(0, first, to.size().x, end - first);
}

}  // namespace

gl::Program& Raycaster::programFor(const char* file, std::vector<std::string> defines,
                                   const RaycastInput& input) {
  if (input.erased && *input.erased) defines.emplace_back("ERASED");
  if (input.behind && input.look == VolumeLook::translucent) defines.emplace_back("BEHIND");
  std::string name = file;
  for (const std::string& define : defines) name += " " + define;
  const auto found = programs_.find(name);
  if (found != programs_.end()) return found->second;
  return programs_
      .emplace(name, gl::Program(std::vector<std::string>{"common/fullscreen.vert", file}, defines))
      .first->second;
}

Raycaster::Raycaster()
    : translucent_({.size = {1, 1}, .colours = {gl::Format::rgba16f}, .filter = gl::Filter::linear}),
      small_({.size = {1, 1}, .filter = gl::Filter::linear}) {}

void Raycaster::draw(const RaycastInput& input, const gl::Target& target) {
  glDisable(GL_BLEND);
  if (input.look == VolumeLook::surface)
    drawSurface(input, target);
  else
    drawTranslucent(input, target);
}

void Raycaster::drawSurface(const RaycastInput& input, const gl::Target& target) {
  const bool coarse = input.raysPerPixel < 1;
  const int samples = coarse ? 1 : std::clamp(int(std::lround(input.raysPerPixel)), 1, 2);
  const glm::ivec2 size = coarse ? scaled(target.size, input.raysPerPixel) : target.size;
  const Box box = worldBox(input.volume.geometry());
  if (input.rows.x <= 0) {
    buffer_.begin({.camera = input.camera,
                   .lighting = input.lighting,
                   .box = box,
                   .pixels = size,
                   .samplesPerSide = samples,
                   .shadowSize = input.shadowSize});
    if (!input.volume.empty()) castShadow(input);
  }
  if (!input.volume.empty()) castSurface(input);
  if (input.rows.y < 1) return;
  if (coarse) small_.fit(size);
  shading_.draw({.buffer = buffer_, .look = MeshLook::amber, .size = 0.7f * box.diagonal()},
                coarse ? gl::Target(small_) : target);
  if (coarse) gl::copyStretched(small_, target);
}

void Raycaster::castShadow(const RaycastInput& input) {
  gl::Program& program = programFor("volume/surface.frag", {"DEPTH_ONLY"}, input);
  setRays(program, input, viewOf(buffer_.lightView));
  setValues(program, input);
  program.set("depthTerms", glm::vec2(0.5f / buffer_.lightView.radius, 0));
  buffer_.shadow.bind();
  program.use();
  gl::drawFullScreen(gl::DepthWrite::on);
}

void Raycaster::castSurface(const RaycastInput& input) {
  const glm::ivec2 pixels = buffer_.frame.pixels;
  gl::Program& program = programFor("volume/surface.frag", {}, input);
  setRays(program, input, viewOf(input.camera, float(pixels.x) / float(pixels.y)));
  setValues(program, input);
  program.set("depthTerms", depthTerms(buffer_.projection));
  bindRows(buffer_.surface, input.rows);
  program.use();
  gl::drawFullScreen(gl::DepthWrite::on);
}

void Raycaster::drawTranslucent(const RaycastInput& input, const gl::Target& target) {
  if (input.rows.x <= 0) {
    translucent_.fit(scaled(target.size, input.raysPerPixel));
    translucent_.clear({});
  }
  const float aspect = float(target.size.x) / float(target.size.y);
  if (!input.volume.empty() && input.look == VolumeLook::translucent) castTranslucent(input, aspect);
  if (!input.volume.empty() && input.look == VolumeLook::maximum) castMaximum(input, aspect);
  if (input.rows.y >= 1) finish(input, target);
}

void Raycaster::finish(const RaycastInput& input, const gl::Target& target) {
  const bool display = input.look == VolumeLook::maximum;
  gl::Program& program =
      programFor("volume/finish.frag",
                 display ? std::vector<std::string>{"DISPLAY"} : std::vector<std::string>{}, input);
  target.bind();
  program.use();
  setLights(program, input.lighting);
  translucent_.colour().bind(0);
  program.set("samples", 0);
  if (input.behind) {
    input.behind->picture.colour().bind(1);
    program.set("behind", 1);
  }
  gl::drawFullScreen();
}

void Raycaster::castMaximum(const RaycastInput& input, float aspect) {
  gl::Program& program = programFor("volume/maximum.frag", {}, input);
  setRays(program, input, viewOf(input.camera, aspect));
  // A peak of one voxel would be missed by half.
  program.set("stepLength", 0.5f * float(input.volume.geometry().minSpacing()));
  input.volume.values().bind(0);
  program.set("values", 0);
  const glm::vec2 terms = input.window.terms();
  program.set("window", terms);
  program.set("brightest", (1 - terms.y) / terms.x);
  bindRows(translucent_, input.rows);
  program.use();
  gl::drawFullScreen();
}

void Raycaster::castTranslucent(const RaycastInput& input, float aspect) {
  const Geometry& g = input.volume.geometry();
  updateTransfer(input);
  std::vector<std::string> defines;
  if (!input.shadows) defines.emplace_back("SHADOWLESS");
  gl::Program& program = programFor("volume/translucent.frag", std::move(defines), input);
  setRays(program, input, viewOf(input.camera, aspect));
  setLights(program, input.lighting);
  input.volume.shades().bind(0);
  program.set("shades", 0);
  if (input.shadows) {
    updateLight(input);
    light_.bind(2);
    program.set("lightMap", 2);
    program.set("lightScale", glm::vec3(g.dims) / glm::vec3(light_.size() * kLightCell));
  }
  transfer_.bind(3);
  program.set("transfer", 3);
  if (input.behind) {
    input.behind->buffer.surface.depth().bind(5);
    program.set("behindDepth", 5);
    program.set("behindTerms", depthTerms(input.behind->buffer.projection));
  }
  program.set("threshold", input.transfer.threshold());
  const glm::mat3 toAxes(glm::transpose(g.direction));
  program.set("keyAxes", toAxes * input.lighting.key.direction);
  program.set("fillAxes", toAxes * input.lighting.fill.direction);
  bindRows(translucent_, input.rows);
  program.use();
  gl::drawFullScreen();
}

void Raycaster::updateTransfer(const RaycastInput& input) {
  Hasher hasher("transfer");
  const float layers = stepLayers(input.volume.geometry());
  const Key key = addTransfer(hasher.add(layers), input.transfer).key();
  if (key == transferKey_) return;
  transfer_ = makeTransferTexture(input.transfer, layers);
  transferKey_ = key;
}

void Raycaster::updateLight(const RaycastInput& input) {
  const Key extinction = extinctionKeyOf(input);
  if (extinction != extinctionKey_) {
    const auto cells = [&](const auto& volume) {
      return extinctionVolume(*volume, input.transfer, kLightCell, input.part);
    };
    extinction_ = input.volume.floats() ? cells(input.volume.floats()) : cells(input.volume.bytes());
    extinctionKey_ = extinction;
  }
  Hasher hasher("light");
  addVector(hasher.add(extinction), input.lighting.key.direction);
  if (const Key key = hasher.key(); key != lightKey_) {
    light_ = lightTexture(lightVolume(extinction_, input.lighting.key.direction));
    lightKey_ = key;
  }
}

}  // namespace sonoskin
