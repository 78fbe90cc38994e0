#include "render/skin/light_maps.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/base/perpendicular.h"
#include "render/skin/gpu_skin.h"
#include "render/surface_shading.h"

namespace sonoskin {
namespace {

// A lamp's view toward the middle of a box.
glm::mat4 lampView(const SkinLight& lamp, const Box& box, glm::vec2& terms, float& width) {
  const glm::vec3 toMiddle = box.centre() - lamp.position;
  const float radius = 0.51f * box.diagonal(), distance = std::max(glm::length(toMiddle), 1e-3f * radius);
  // A lamp in the very middle looks anywhere.
  const glm::vec3 forward =
      glm::length(toMiddle) < 0.5f * distance ? glm::vec3(0, 1, 0) : toMiddle / distance;
  // From within the sphere around the box no view sees all of it: the part before the lamp must do.
  const float half = distance > 1.05f * radius ? std::asin(radius / distance) : glm::radians(70.f);
  const float near = std::max(distance - radius, 0.02f * radius), far = distance + radius;
  const glm::mat4 projection = glm::perspective(2 * half, 1.f, near, far);
  const glm::vec3 up = axisAside<2, 0>(forward);
  terms = depthTerms(projection);
  width = 2 * std::tan(half) * distance;
  return projection * glm::lookAt(lamp.position, lamp.position + forward, up);
}

// Texels along the side of a map `width` mm wide over an atlas with texels of `texel` mm.
int mapSize(float width, float texel, int most) {
  constexpr float kPerTexel = 2;
  constexpr int kStep = 64;
  const float enough = kPerTexel * width / texel;
  return enough < float(most) ? std::min((int(enough) / kStep + 1) * kStep, most) : most;
}

}  // namespace

std::string kindDefine(const LightRig& lights) { return fmt::format("KIND {}", int(lights.lights[0].kind)); }

LightMaps::LightMaps()
    : program_({"skin/light_depth.vert", "skin/light_depth.frag"}),
      hiddenProgram_({"skin/light_depth.vert", "skin/light_depth.frag"}, {"HIDDEN"}) {
  gl::FramebufferDescription depths{.size = {1, 1}, .colours = {}, .depth = gl::Format::depth32f};
  for (Map& map : maps_) {
    map.exits = gl::Framebuffer(depths);
    map.target = gl::Framebuffer(depths);
  }
  // Of light 0 alone: where it enters.
  depths.colours = {gl::Format::rg16};
  maps_[0].target = gl::Framebuffer(depths);
}

// Draws the triangles that do not face the culled way.
void LightMaps::drawFacing(const GpuSkin& surface, const glm::mat4& view, unsigned culled,
                           const gl::Framebuffer& to) {
  to.clear({});
  to.bind();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glEnable(GL_CULL_FACE);
  glCullFace(culled);
  glDisable(GL_BLEND);
  program_.use();
  program_.set("viewProjection", view);
  surface.parts().drawAll();
  if (surface.parts().hides()) {
    hiddenProgram_.use();
    hiddenProgram_.set("viewProjection", view);
    surface.parts().drawHidden();
  }
  glCullFace(GL_BACK);
  glDisable(GL_CULL_FACE);
}

void LightMaps::draw(const GpuSkin& surface, const LightRig& lights, std::size_t i, int most) {
  const SkinLight light = lights.light(i);
  Map& map = maps_[i];
  const bool comesThrough = light.shadows && i == 0;
  glm::mat4 view(1);
  float width = 1;
  if (light.kind == LightKind::far) {
    const LightView far(light.position, surface.box());
    view = far.projection();
    width = 2 * far.radius;
    map.terms = {width, 0};
  } else {
    view = lampView(light, surface.box(), map.terms, width);
  }
  const int size = mapSize(width, surface.surface()->atlas.texel, most);
  map.target.fit(light.shadows ? glm::ivec2(size) : glm::ivec2(1));
  map.exits.fit(comesThrough ? glm::ivec2(size) : glm::ivec2(1));
  if (!light.shadows) return;
  map.texel = width / float(size);
  map.toMap = glm::scale(glm::translate(glm::mat4(1), glm::vec3(0.5f)), glm::vec3(0.5f)) * view;
  drawFacing(surface, view, GL_BACK, map.target);
  if (comesThrough) drawFacing(surface, view, GL_FRONT, map.exits);
}

void LightMaps::giveBack() {
  for (Map& map : maps_)
    for (gl::Framebuffer* f : {&map.target, &map.exits}) f->fit({1, 1});
}

void LightMaps::setLights(gl::Program& program, const LightRig& lights) const {
  for (std::size_t i = 0; i < LightRig::kMost; ++i) {
    const SkinLight light = lights.light(i);
    const auto set = [&](const char* member, const auto& value) {
      program.set(fmt::format("lights[{}].{}", i, member).c_str(), value);
    };
    set("position", light.position);
    set("colour", light.colour);
    set("reach", light.reach);
    set("softness", light.softness);
    set("shadows", light.shadows ? 1.f : 0.f);
    set("toMap", maps_[i].toMap);
    set("terms", maps_[i].terms);
    set("texel", maps_[i].texel);
  }
  for (std::size_t k = 0; k < lights.environment.size(); ++k)
    program.set(fmt::format("environment[{}]", k).c_str(), lights.environment[k]);
}

std::size_t LightMaps::bytes() const {
  std::size_t sum = 0;
  for (const Map& map : maps_) sum += map.target.texels() * 4 + map.exits.texels() * 4;
  return sum + maps_[0].target.texels() * 4;
}

}  // namespace sonoskin
