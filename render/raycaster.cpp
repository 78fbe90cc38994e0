#include "render/raycaster.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>

#include "render/light_volume.h"

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
  program.set("boxMin", input.cropMin * last);
  program.set("boxMax", input.cropMax * last);
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

Key lightKeyOf(const RaycastInput& input) {
  Hasher hasher("light");
  hasher.add(input.volume.number());
  for (int c = 0; c < 3; ++c) hasher.add(input.lighting.key.direction[c]);
  for (const auto& p : input.transfer.points)
    hasher.add(p.value).add(p.opacity).add(p.colour.x).add(p.colour.y).add(p.colour.z);
  return hasher.key();
}

// How many of the layers that a transfer function's opacity means one step of a ray passes.
float stepLayers(const Geometry& g) { return float(g.minSpacing() * 250 / worldDiagonal(g)); }

gl::Texture lightTexture(const Volume<float>& light) {
  std::vector<std::uint8_t> texels;
  texels.reserve(light.data.size());
  for (const float share : light.data) texels.push_back(std::uint8_t(255 * share + 0.5f));
  gl::Texture texture({.size = light.geometry.dims, .format = gl::Format::r8});
  texture.upload(texels.data());
  return texture;
}

glm::ivec2 scaled(glm::ivec2 size, float factor) {
  return glm::max(glm::ivec2(glm::round(glm::vec2(size) * factor)), glm::ivec2(1));
}

}  // namespace

gl::Program& Raycaster::Caster::programFor(const RaycastInput& input) {
  const bool erased = input.erased && *input.erased;
  auto& program = programs[erased];
  if (!program) {
    std::vector<std::string> all = defines;
    if (erased) all.push_back("ERASED");
    program.emplace(std::vector<std::string>{"common/fullscreen.vert", file}, all);
  }
  return *program;
}

Raycaster::Raycaster()
    : finishProgram_({"common/fullscreen.vert", "volume/finish.frag"}),
      translucent_({.size = {1, 1}, .colours = {gl::Format::rgba16f}, .filter = gl::Filter::linear}),
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
  buffer_.begin({.camera = input.camera,
                 .lighting = input.lighting,
                 .box = box,
                 .pixels = size,
                 .samplesPerSide = samples,
                 .shadowSize = input.shadowSize});
  if (input.volume.floats()) castSurface(input);
  if (coarse) small_.fit(size);
  shading_.draw({.buffer = buffer_, .look = MeshLook::amber, .size = 0.7f * box.diagonal()},
                coarse ? gl::Target(small_) : target);
  if (coarse) gl::copyStretched(small_, target);
}

void Raycaster::castSurface(const RaycastInput& input) {
  const auto cast = [&](Caster& caster, const View& view, glm::vec2 depths, const gl::Framebuffer& to) {
    gl::Program& program = caster.programFor(input);
    setRays(program, input, view);
    setValues(program, input);
    program.set("depthTerms", depths);
    to.bind();
    program.use();
    gl::drawFullScreen(gl::DepthWrite::on);
  };
  const glm::ivec2 pixels = buffer_.frame.pixels;
  cast(shadowCaster_, viewOf(buffer_.lightView), {0.5f / buffer_.lightView.radius, 0}, buffer_.shadow);
  cast(surfaceCaster_, viewOf(input.camera, float(pixels.x) / float(pixels.y)),
       depthTerms(buffer_.projection), buffer_.surface);
}

void Raycaster::drawTranslucent(const RaycastInput& input, const gl::Target& target) {
  translucent_.fit(scaled(target.size, input.raysPerPixel));
  translucent_.clear({});
  if (input.volume.floats()) castTranslucent(input, float(target.size.x) / float(target.size.y));
  target.bind();
  finishProgram_.use();
  setLights(finishProgram_, input.lighting);
  translucent_.colour().bind(0);
  finishProgram_.set("samples", 0);
  gl::drawFullScreen();
}

void Raycaster::castTranslucent(const RaycastInput& input, float aspect) {
  const Geometry& g = input.volume.geometry();
  updateLight(input);
  gl::Program& program = translucentCaster_.programFor(input);
  setRays(program, input, viewOf(input.camera, aspect));
  setLights(program, input.lighting);
  input.volume.shades().bind(0);
  light_.bind(2);
  transfer_.bind(3);
  program.set("shades", 0);
  program.set("lightMap", 2);
  program.set("transfer", 3);
  program.set("lightScale", 1.0f / glm::vec3(light_.size() * kLightCell));
  program.set("threshold", input.transfer.threshold());
  const glm::mat3 toAxes(glm::transpose(g.direction));
  program.set("keyAxes", toAxes * input.lighting.key.direction);
  program.set("fillAxes", toAxes * input.lighting.fill.direction);
  translucent_.bind();
  program.use();
  gl::drawFullScreen();
}

void Raycaster::updateLight(const RaycastInput& input) {
  const Key key = lightKeyOf(input);
  if (key == lightKey_) return;
  const Volume<float>& volume = *input.volume.floats();
  transfer_ = makeTransferTexture(input.transfer, stepLayers(volume.geometry));
  light_ = lightTexture(lightVolume(volume, input.transfer, input.lighting.key.direction, kLightCell));
  lightKey_ = key;
}

}  // namespace sonoskin
