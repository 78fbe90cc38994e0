#include "render/surface_shading.h"

#include <glad/gl.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

namespace sonoskin {
namespace {

// Shares of the size of what is shown.
constexpr float kOcclusionRadius = 0.055f, kPenumbra = 0.008f;

const char* defineOf(MeshLook look) {
  switch (look) {
    case MeshLook::clay:
      return "CLAY";
    case MeshLook::skin:
      return "SKIN";
    case MeshLook::amber:
      return "AMBER";
    case MeshLook::parts:
      return "PARTS";
  }
  return "";
}

void setShadow(gl::Program& program, const ShadingInput& input) {
  const glm::mat4 toUnit = glm::scale(glm::translate(glm::mat4(1), glm::vec3(0.5f)), glm::vec3(0.5f));
  const float side = 2 * input.lightView.radius, penumbra = kPenumbra * input.size;
  program.set("shadowMatrix", toUnit * input.lightView.projection());
  program.set("shadowRadius", penumbra / side);
  // One and a half shadow texels and half a penumbra.
  program.set("shadowOffset", 1.5f * side / float(input.shadow.size().x) + 0.5f * penumbra);
}

}  // namespace

gl::FramebufferDescription surfaceBuffer() {
  return {.size = {1, 1}, .colours = {gl::Format::rgba16f}, .depth = gl::Format::depth32f};
}

gl::FramebufferDescription shadowBuffer() {
  return {.size = {1, 1}, .colours = {}, .depth = gl::Format::depth32f, .depthCompare = true};
}

LightView::LightView(const glm::vec3& light, const Box& box)
    : centre(box.centre()), toLight(light), radius(0.51f * box.diagonal()) {
  const glm::vec3 other = std::abs(light.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  right = glm::normalize(glm::cross(other, toLight));
  up = glm::cross(toLight, right);
}

glm::mat4 LightView::projection() const {
  return glm::ortho(-radius, radius, -radius, radius, 0.0f, 2 * radius) *
         glm::lookAt(centre + radius * toLight, centre, up);
}

glm::vec2 depthTerms(const glm::mat4& projection) {
  // From z_ndc = 2 depth - 1 = -p22 + p32 / distance (p23 = -1).
  return {-0.5f * projection[3][2], 0.5f * (1 - projection[2][2])};
}

void setScreen(gl::Program& program, const Camera& camera, float aspect, const glm::mat4& projection) {
  const float tangent = std::tan(0.5f * glm::radians(camera.fieldOfView));
  program.set("eye", camera.eye());
  program.set("viewCentre", camera.forward);
  program.set("viewRight", camera.right() * tangent * aspect);
  program.set("viewUp", camera.up * tangent);
  program.set("depthTerms", depthTerms(projection));
}

SurfaceShading::SurfaceShading()
    : occlusionProgram_({"common/fullscreen.vert", "surface/occlusion.frag"}),
      occlusion_({.size = {1, 1}, .colours = {gl::Format::rgba16f}}) {}

gl::Program& SurfaceShading::shadeProgram(const ShadingInput& input) {
  const int variant = input.samplesPerSide == 1 ? 0 : input.outline ? 2 : 1;
  auto& program = shadePrograms_[std::size_t(kVariants * int(input.look) + variant)];
  if (!program) {
    std::vector<std::string> defines{defineOf(input.look), "SAMPLES " + std::to_string(input.samplesPerSide)};
    if (variant == 2) defines.emplace_back("OUTLINE");
    program = std::make_unique<gl::Program>(
        std::vector<std::string>{"common/fullscreen.vert", "surface/shade.frag"}, defines);
  }
  return *program;
}

void SurfaceShading::occlude(const ShadingInput& input, glm::ivec2 size) {
  occlusion_.fit(size);
  occlusion_.bind();
  auto& program = occlusionProgram_;
  program.use();
  input.surface.colour().bind(0);
  input.surface.depth().bind(1);
  program.set("normalMap", 0);
  program.set("depthMap", 1);
  input.shadow.depth().bind(2);
  program.set("shadowMap", 2);
  program.set("keyDirection", input.lighting.key.direction);
  setShadow(program, input);
  program.set("step", input.samplesPerSide);
  program.set("radius", kOcclusionRadius * input.size);
  program.set("pixelsPerTangent", 0.5f * float(size.y) * input.projection[1][1]);
  setScreen(program, input.camera, float(size.x) / float(size.y), input.projection);
  gl::drawFullScreen();
}

void SurfaceShading::draw(const ShadingInput& input, const gl::Target& target) {
  glDisable(GL_BLEND);
  occlude(input, target.size);
  auto& program = shadeProgram(input);
  target.bind();
  program.use();
  input.surface.colour().bind(0);
  input.surface.depth().bind(1);
  occlusion_.colour().bind(2);
  program.set("normalMap", 0);
  program.set("depthMap", 1);
  program.set("occlusionMap", 2);
  setLights(program, input.lighting);
  setScreen(program, input.camera, float(target.size.x) / float(target.size.y), input.projection);
  program.set("unseenShade", input.unseenShade);
  if (input.samplesPerSide > 1 && input.outline) {
    input.outline->bind(3);
    program.set("outlineMap", 3);
  }
  gl::drawFullScreen();
}

}  // namespace sonoskin
