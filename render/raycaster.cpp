#include "render/raycaster.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>

#include "core/base/hash.h"
#include "render/light_volume.h"

namespace sonoskin {
namespace {

constexpr int kLightCell = 4;  // voxels

// The uniforms of shaders/volume/ray.glsl.
void setRays(gl::Program& program, const RaycastInput& input, float aspect) {
  const Geometry& g = input.volume.geometry();
  const Camera& camera = input.camera;
  const float tangent = std::tan(0.5f * glm::radians(camera.fieldOfView));
  const glm::vec3 centre = camera.forward, right = camera.right() * tangent * aspect,
                  up = camera.up * tangent;
  const glm::mat3 toIndex(glm::transpose(g.direction));
  const auto along = [&](const glm::vec3& world) { return toIndex * world / glm::vec3(g.spacing); };
  program.set("eyeIndex", glm::vec3(g.toIndex(glm::dvec3(camera.eye()))));
  program.set("rayCentre", along(centre));
  program.set("rayRight", along(right));
  program.set("rayUp", along(up));
  program.set("viewCentre", centre);
  program.set("viewRight", right);
  program.set("viewUp", up);
  program.set("dims", g.dims);
  const glm::vec3 last(g.dims - 1);
  program.set("boxMin", input.cropMin * last);
  program.set("boxMax", input.cropMax * last);
  program.set("stepLength", float(g.minSpacing()));
  input.volume.bricks().bind(1);
  program.set("bricks", 1);
}

Key lightKeyOf(const RaycastInput& input) {
  Hasher hasher("light");
  hasher.add(input.volume.values().name());
  for (int c = 0; c < 3; ++c) hasher.add(input.lighting.key.direction[c]);
  for (const auto& p : input.transfer.points)
    hasher.add(p.value).add(p.opacity).add(p.colour.x).add(p.colour.y).add(p.colour.z);
  return hasher.add(input.shadows).key();
}

}  // namespace

Raycaster::Raycaster()
    : surfaceProgram_({"common/fullscreen.vert", "volume/surface.frag"}),
      shadowedProgram_({"common/fullscreen.vert", "volume/surface.frag"}, {"SHADOW"}),
      translucentProgram_({"common/fullscreen.vert", "volume/translucent.frag"}),
      samples_({.size = {1, 1}, .colours = {gl::Format::rgba16f}, .depth = gl::Format::depth32f}),
      small_({.size = {1, 1}, .filter = gl::Filter::linear}) {}

void Raycaster::draw(const RaycastInput& input, const gl::Target& target) {
  const float aspect = float(target.size.x) / float(target.size.y);
  const glm::mat4 projection = input.camera.projection(aspect, worldBox(input.volume.geometry()));
  samples_.fit(glm::max(glm::ivec2(glm::round(glm::vec2(target.size) * input.raysPerPixel)), glm::ivec2(1)));
  const bool surface = input.look == VolumeLook::surface;
  samples_.clear(surface ? glm::vec4(0, 0, 0, -1) : glm::vec4(0));
  if (input.volume.floats()) {
    if (surface)
      castSurface(input, projection);
    else
      castTranslucent(input);
  }
  finish(input, projection, target);
}

void Raycaster::castSurface(const RaycastInput& input, const glm::mat4& projection) {
  const Geometry& g = input.volume.geometry();
  auto& program = input.shadows ? shadowedProgram_ : surfaceProgram_;
  setRays(program, input, float(samples_.size().x) / float(samples_.size().y));
  setLights(program, input.lighting);
  input.volume.values().bind(0);
  program.set("values", 0);
  program.set("iso", input.iso);
  program.set("smoothing", input.gradientReach);
  const glm::mat3 axes(g.direction);
  const glm::vec3 spacing(g.spacing);
  program.set("gradientToWorld", glm::mat3(axes[0] / spacing.x, axes[1] / spacing.y, axes[2] / spacing.z));
  program.set("keyIndex", glm::transpose(axes) * input.lighting.key.direction / spacing);
  program.set("diagonal", float(worldDiagonal(g)));
  program.set("depthTerms", glm::vec2(-0.5f * projection[3][2], 0.5f * (1 - projection[2][2])));
  samples_.bind();
  glDisable(GL_BLEND);
  program.use();
  gl::drawFullScreen(gl::DepthWrite::on);
}

void Raycaster::castTranslucent(const RaycastInput& input) {
  const Geometry& g = input.volume.geometry();
  updateLight(input);
  auto& program = translucentProgram_;
  setRays(program, input, float(samples_.size().x) / float(samples_.size().y));
  setLights(program, input.lighting);
  input.volume.shades().bind(0);
  light_.bind(2);
  transfer_.bind(3);
  program.set("shades", 0);
  program.set("lightMap", 2);
  program.set("transfer", 3);
  program.set("lightScale", 1.0f / glm::vec3(light_.size() * kLightCell));
  program.set("threshold", input.transfer.threshold());
  program.set("stepOpacity", float(g.minSpacing() * 250 / worldDiagonal(g)));
  const glm::mat3 toAxes(glm::transpose(g.direction));
  program.set("keyAxes", toAxes * input.lighting.key.direction);
  program.set("fillAxes", toAxes * input.lighting.fill.direction);
  samples_.bind();
  glDisable(GL_BLEND);
  program.use();
  gl::drawFullScreen();
}

void Raycaster::updateLight(const RaycastInput& input) {
  const Key key = lightKeyOf(input);
  if (key == lightKey_) return;
  lightKey_ = key;
  transfer_ = makeTransferTexture(input.transfer);
  const auto& volume = *input.volume.floats();
  const Volume<float> light =
      input.shadows ? lightVolume(volume, input.transfer, input.lighting.key.direction, kLightCell)
                    : Volume<float>(Geometry{.dims = glm::ivec3(1)}, 1.0f);
  light_ = gl::Texture({.size = light.geometry.dims, .format = gl::Format::r32f});
  light_.upload(light.data.data());
}

void Raycaster::finish(const RaycastInput& input, const glm::mat4& projection, const gl::Target& target) {
  const bool coarse = input.raysPerPixel < 1;
  if (coarse) small_.fit(samples_.size());
  const gl::Target to = coarse ? gl::Target(small_) : target;
  const FinishInput in{.samples = samples_,
                       .lighting = input.lighting,
                       .projection = projection,
                       .supersampling = std::max(int(std::lround(input.raysPerPixel)), 1),
                       .radius = 0.04f * float(worldDiagonal(input.volume.geometry()))};
  if (input.look == VolumeLook::surface)
    finish_.surface(in, to);
  else
    finish_.volume(in, to);
  if (coarse) gl::copyStretched(small_, target);
}

}  // namespace sonoskin
