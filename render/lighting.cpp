#include "render/lighting.h"

namespace sonoskin {

Lighting portraitLighting(const Camera& camera) {
  const glm::vec3 right = camera.right(), up = camera.up, toEye = -camera.forward;
  Lighting l;
  l.key = {glm::normalize(-0.62f * right + 0.66f * up + 0.62f * toEye), {1.30f, 1.22f, 1.10f}};
  l.fill = {glm::normalize(0.85f * right + 0.05f * up + 0.60f * toEye), {0.20f, 0.23f, 0.28f}};
  l.rim = {glm::normalize(0.55f * right + 0.60f * up - 0.60f * toEye), {0.50f, 0.52f, 0.58f}};
  l.sky = {0.30f, 0.31f, 0.33f};
  l.ground = {0.13f, 0.11f, 0.10f};
  l.skyDirection = glm::normalize(up + 0.4f * toEye);
  l.backgroundTop = {0.030f, 0.036f, 0.046f};
  l.backgroundBottom = {0.006f, 0.007f, 0.009f};
  return l;
}

void setLights(gl::Program& program, const Lighting& l) {
  program.set("keyDirection", l.key.direction);
  program.set("keyColour", l.key.colour);
  program.set("fillDirection", l.fill.direction);
  program.set("fillColour", l.fill.colour);
  program.set("rimDirection", l.rim.direction);
  program.set("rimColour", l.rim.colour);
  program.set("skyColour", l.sky);
  program.set("groundColour", l.ground);
  program.set("skyDirection", l.skyDirection);
}

}  // namespace sonoskin
