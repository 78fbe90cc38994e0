#include "render/mesh_view.h"

#include <glad/gl.h>

#include <glm/gtc/matrix_transform.hpp>

namespace sonoskin {
namespace {

// The smallest orthographic view along the light that holds the box's sphere.
glm::mat4 lightProjection(const glm::vec3& toLight, const Box& box) {
  const float r = 0.51f * box.diagonal();
  const glm::vec3 up = std::abs(toLight.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  return glm::ortho(-r, r, -r, r, 0.0f, 2 * r) * glm::lookAt(box.centre() + r * toLight, box.centre(), up);
}

// Shares of the box's diagonal.
constexpr float kOcclusionRadius = 0.055f, kPenumbra = 0.008f;

}  // namespace

MeshView::MeshView()
    : shadowProgram_({"mesh/shadow.vert", "mesh/shadow.frag"}),
      clayProgram_({"mesh/mesh.vert", "mesh/mesh.frag"}),
      skinProgram_({"mesh/mesh.vert", "mesh/mesh.frag"}, {"SKIN"}),
      shadow_({.size = {1, 1}, .colours = {}, .depth = gl::Format::depth32f, .depthCompare = true}),
      samples_({.size = {1, 1}, .colours = {gl::Format::rgba16f}, .depth = gl::Format::depth32f}) {}

void MeshView::draw(const MeshViewInput& input, const gl::Target& target) {
  const float aspect = float(target.size.x) / float(target.size.y);
  const glm::mat4 projection = input.camera.projection(aspect, input.mesh.box());
  samples_.fit(target.size * input.supersampling);
  samples_.clear({0, 0, 0, -1});
  if (!input.mesh.empty()) {
    drawShadowMap(input);
    drawSamples(input, projection);
  }
  finish_.surface({.samples = samples_,
                   .lighting = input.lighting,
                   .projection = projection,
                   .supersampling = input.supersampling,
                   .radius = kOcclusionRadius * input.mesh.box().diagonal()},
                  target);
}

void MeshView::drawShadowMap(const MeshViewInput& input) {
  shadowProjection_ = lightProjection(input.lighting.key.direction, input.mesh.box());
  shadow_.fit(glm::ivec2(input.shadowSize));
  shadow_.clear({});
  shadow_.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  shadowProgram_.use();
  shadowProgram_.set("shadowProjection", shadowProjection_);
  input.mesh.draw();
}

void MeshView::drawSamples(const MeshViewInput& input, const glm::mat4& projection) {
  samples_.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  auto& program = input.look == MeshLook::skin ? skinProgram_ : clayProgram_;
  program.use();
  setLights(program, input.lighting);
  shadow_.depth().bind(0);
  program.set("shadowMap", 0);
  const glm::mat4 toUnit = glm::scale(glm::translate(glm::mat4(1), glm::vec3(0.5f)), glm::vec3(0.5f));
  program.set("shadowMatrix", toUnit * shadowProjection_);
  // The penumbra, and a step along the normal of one and a half shadow texels and half a penumbra.
  const float diagonal = input.mesh.box().diagonal(), side = 1.02f * diagonal;
  program.set("shadowRadius", kPenumbra * diagonal / side);
  program.set("shadowOffset", 1.5f * side / float(input.shadowSize) + 0.5f * kPenumbra * diagonal);
  program.set("viewProjection", projection * input.camera.view());
  program.set("eye", input.camera.eye());
  program.set("unseenShade", input.unseenShade);
  input.mesh.draw();
}

}  // namespace sonoskin
