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
  const SurfaceBuffer& buffer = input.buffer;
  const float side = 2 * buffer.lightView.radius, penumbra = kPenumbra * input.size;
  program.set("shadowMatrix", toUnit * buffer.lightView.projection());
  program.set("shadowRadius", penumbra / side);
  // One and a half shadow texels and half a penumbra.
  program.set("shadowOffset", 1.5f * side / float(buffer.shadow.size().x) + 0.5f * penumbra);
}

// The surface and the camera that sees it, at texture units 0 and 1.
void bindSurface(gl::Program& program, const SurfaceBuffer& buffer) {
  buffer.surface.colour().bind(0);
  buffer.surface.depth().bind(1);
  program.set("normalMap", 0);
  program.set("depthMap", 1);
  const glm::ivec2 pixels = buffer.frame.pixels;
  setScreen(program, buffer.frame.camera, float(pixels.x) / float(pixels.y), buffer.projection);
}

}  // namespace

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
  const int samples = input.buffer.frame.samplesPerSide, variant = samples == 1 ? 0 : input.outline ? 2 : 1;
  auto& program = shadePrograms_[std::size_t(kVariants * int(input.look) + variant)];
  if (!program) {
    std::vector<std::string> defines{defineOf(input.look), "SAMPLES " + std::to_string(samples)};
    if (variant == 2) defines.emplace_back("OUTLINE");
    program = std::make_unique<gl::Program>(
        std::vector<std::string>{"common/fullscreen.vert", "surface/shade.frag"}, defines);
  }
  return *program;
}

void SurfaceShading::occlude(const ShadingInput& input) {
  const SurfaceBuffer& buffer = input.buffer;
  occlusion_.fit(buffer.frame.pixels);
  occlusion_.bind();
  auto& program = occlusionProgram_;
  program.use();
  bindSurface(program, buffer);
  buffer.shadow.depth().bind(2);
  program.set("shadowMap", 2);
  program.set("keyDirection", buffer.frame.lighting.key.direction);
  setShadow(program, input);
  program.set("step", buffer.frame.samplesPerSide);
  program.set("radius", kOcclusionRadius * input.size);
  program.set("pixelsPerTangent", 0.5f * float(buffer.frame.pixels.y) * buffer.projection[1][1]);
  gl::drawFullScreen();
}

void SurfaceShading::draw(const ShadingInput& input, const gl::Target& target) {
  glDisable(GL_BLEND);
  occlude(input);
  auto& program = shadeProgram(input);
  target.bind();
  program.use();
  bindSurface(program, input.buffer);
  occlusion_.colour().bind(2);
  program.set("occlusionMap", 2);
  setLights(program, input.buffer.frame.lighting);
  program.set("unseenShade", input.unseenShade);
  if (input.buffer.frame.samplesPerSide > 1 && input.outline) {
    input.outline->bind(3);
    program.set("outlineMap", 3);
  }
  gl::drawFullScreen();
}

}  // namespace sonoskin
