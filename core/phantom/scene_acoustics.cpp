#include "core/phantom/scene_acoustics.h"

namespace sonoskin {
namespace {

constexpr float kPlanes = 0.0203f;  // 1.6 mm at 79 mm from the apex, where faces are

SceneAcoustics thick() {
  SceneAcoustics a;
  a.spread = {0.38f, 0.0125f, 0.0150f};
  a.reflection.layer = 0.5f;
  a.reflection.aside = 0.3f, a.reflection.facing = 0.7f;
  a.reflection.lossBaby = 0.8f, a.reflection.lossBone = 18;
  a.reflection.tissue = 8;
  a.display.white = -21.5f, a.display.range = 25;
  return a;
}

SceneAcoustics saturated() {
  SceneAcoustics a;
  a.reflection.skin = 4, a.reflection.bone = -2, a.reflection.wall = -1;
  a.reflection.tissue = 5.5f;
  a.display.white = -25, a.display.range = 32;
  return a;
}

SceneAcoustics enhanced() {
  SceneAcoustics a;
  a.display.smoothing = 0.5f;
  a.display.threshold = 0.26f, a.display.ceiling = 0.7f;
  a.receiver = -3;  // these scanners average pictures
  return a;
}

// Thinner pulses and beams than `thick`: its own smoothing does the rest.
SceneAcoustics clinical() {
  SceneAcoustics a = thick();
  a.spread = {0.33f, 0.01f, 0.012f};
  a.reflection.layer = 0.3f;
  a.reflection.lossBaby = 0.6f;
  a.reflection.tissue = 7;
  a.display = {-20, 32, 0.45f, 0.25f, 0.84f};
  a.receiver = -6;
  a.planes = kPlanes;
  a.elevationAngle = 0.40f;
  return a;
}

}  // namespace

SceneAcoustics sceneAcoustics(PhantomScene scene) {
  SceneAcoustics a;
  switch (scene) {
    case PhantomScene::thick:
      return thick();
    case PhantomScene::haze:
      a.haze = {-31, 5};
      return a;
    case PhantomScene::saturated:
      return saturated();
    case PhantomScene::enhanced:
      return enhanced();
    case PhantomScene::planes:
      a.planes = kPlanes;
      return a;
    case PhantomScene::clinical:
      return clinical();
    default:
      return a;
  }
}

}  // namespace sonoskin
