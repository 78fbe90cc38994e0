#include "render/mesh_view.h"

#include <glad/gl.h>

namespace sonoskin {
namespace {

void drawMesh(const MeshViewInput& input, gl::Program& program, const glm::mat4& viewProjection,
              const gl::Framebuffer& target) {
  target.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  program.use();
  program.set("viewProjection", viewProjection);
  const ClipInUse clipped(program, input.clip);
  input.mesh.draw();
}

}  // namespace

MeshView::MeshView()
    : shadowProgram_({"mesh/shadow.vert", "mesh/shadow.frag"}),
      surfaceProgram_({"mesh/mesh.vert", "mesh/mesh.frag"}) {}

void MeshView::draw(const MeshViewInput& input, const gl::Target& target) {
  const Box& box = input.mesh.box();
  buffer_.begin({.camera = input.camera,
                 .lighting = input.lighting,
                 .box = box,
                 .pixels = target.size,
                 .samplesPerSide = input.supersampling,
                 .shadowSize = input.shadowSize});
  const glm::mat4 viewProjection = buffer_.viewProjection();
  drawMesh(input, shadowProgram_, buffer_.lightView.projection(), buffer_.shadow);
  drawMesh(input, surfaceProgram_, viewProjection, buffer_.surface);
  const gl::Texture* outline = nullptr;
  if (input.supersampling > 1)
    outline = &outline_.draw(buffer_.surface.size(), viewProjection, input.clip, [&] { input.mesh.draw(); });
  shading_.draw({.buffer = buffer_,
                 .look = input.look,
                 .size = box.diagonal(),
                 .unseenShade = input.unseenShade,
                 .outline = outline},
                target);
}

}  // namespace sonoskin
