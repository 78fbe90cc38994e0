#include "render/surface_buffer.h"

#include <glm/gtc/matrix_transform.hpp>

#include "core/base/perpendicular.h"

namespace sonoskin {

LightView::LightView(const glm::vec3& light, const Box& box)
    : centre(box.centre()), toLight(light), radius(0.51f * box.diagonal()) {
  right = glm::normalize(glm::cross(axisAside<2, 0>(light), toLight));
  up = glm::cross(toLight, right);
}

glm::mat4 LightView::projection() const {
  return glm::ortho(-radius, radius, -radius, radius, 0.0f, 2 * radius) *
         glm::lookAt(centre + radius * toLight, centre, up);
}

gl::FramebufferDescription surfaceTexels(const std::vector<gl::Format>& material) {
  gl::FramebufferDescription texels{
      .size = {1, 1}, .colours = {gl::Format::rgba16f}, .depth = gl::Format::depth32f};
  texels.colours.insert(texels.colours.end(), material.begin(), material.end());
  return texels;
}

SurfaceBuffer::SurfaceBuffer()
    : surface(surfaceTexels()),
      shadow({.size = {1, 1}, .colours = {}, .depth = gl::Format::depth32f, .depthCompare = true}) {}

void SurfaceBuffer::begin(const SurfaceFrame& next) {
  frame = next;
  projection = frame.camera.projection(float(frame.pixels.x) / float(frame.pixels.y), frame.box);
  lightView = LightView(frame.lighting.key.direction, frame.box);
  surface.fit(frame.pixels * frame.samplesPerSide);
  surface.clear({});
  shadow.fit(glm::ivec2(frame.shadowSize));
  shadow.clear({});
}

glm::vec2 depthTerms(const glm::mat4& projection) {
  // From z_ndc = 2 depth - 1 = -p22 + p32 / distance (p23 = -1).
  return {-0.5f * projection[3][2], 0.5f * (1 - projection[2][2])};
}

}  // namespace sonoskin
