#include "render/mesh_view.h"

#include <glad/gl.h>

namespace sonoskin {
namespace {

void drawMesh(const GpuMesh& mesh, gl::Program& program, const glm::mat4& viewProjection,
              const gl::Framebuffer& target) {
  target.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  program.use();
  program.set("viewProjection", viewProjection);
  mesh.draw();
}

}  // namespace

MeshView::MeshView()
    : shadowProgram_({"mesh/shadow.vert", "mesh/shadow.frag"}),
      surfaceProgram_({"mesh/mesh.vert", "mesh/mesh.frag"}),
      shadow_(shadowBuffer()),
      surface_(surfaceBuffer()) {}

void MeshView::draw(const MeshViewInput& input, const gl::Target& target) {
  const float aspect = float(target.size.x) / float(target.size.y);
  const Box& box = input.mesh.box();
  const glm::mat4 projection = input.camera.projection(aspect, box);
  const LightView lightView(input.lighting.key.direction, box);
  surface_.fit(target.size * input.supersampling);
  surface_.clear({});
  shadow_.fit(glm::ivec2(input.shadowSize));
  shadow_.clear({});
  drawMesh(input.mesh, shadowProgram_, lightView.projection(), shadow_);
  drawMesh(input.mesh, surfaceProgram_, projection * input.camera.view(), surface_);
  const gl::Texture* outline = nullptr;
  if (input.supersampling > 1)
    outline = &outline_.draw(surface_.size(), projection * input.camera.view(), [&] { input.mesh.draw(); });
  shading_.draw({.surface = surface_,
                 .shadow = shadow_,
                 .lightView = lightView,
                 .camera = input.camera,
                 .lighting = input.lighting,
                 .projection = projection,
                 .look = input.look,
                 .samplesPerSide = input.supersampling,
                 .size = box.diagonal(),
                 .unseenShade = input.unseenShade,
                 .outline = outline},
                target);
}

}  // namespace sonoskin
