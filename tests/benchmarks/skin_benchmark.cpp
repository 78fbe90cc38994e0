// The skin view at 1280x720 in light quality: what turning the camera and moving the light cost, on a ball with bumps that
// has the area of a baby's face (14,000 mm²), reduced to 100,000 triangles. Asked for on a software renderer with two cores: 12
// pictures a second without pores, 10 with (83 and 100 ms), light anew in 200 ms.
#include <benchmark/benchmark.h>

#include "render/gl/context.h"
#include "render/skin/skin_view.h"
#include "tests/support/meshes.h"

namespace sonoskin {
namespace {

std::shared_ptr<const Mesh> bumpyBall() {
  Mesh mesh = test::icosphere(7, 33, {0, 0, 0});
  for (glm::vec3& p : mesh.positions) {
    const glm::vec3 d = p / 33.f;
    p += d * 1.2f * std::sin(7 * d.x) * std::sin(6 * d.y + 1) * std::sin(5 * d.z + 2);
  }
  mesh.normals.clear();
  computeNormals(mesh);
  return std::make_shared<const Mesh>(std::move(mesh));
}

struct Scene {
  std::unique_ptr<gl::Context> context = gl::makeOffscreenContext(gl::Backend::egl);
  SkinQuality quality = lightQuality();
  GpuSkin skin;
  SkinView view;
  Camera camera;
  SkinLook look;
  gl::Framebuffer picture;

  Scene() {
    context->makeCurrent();
    skin.set(prepareSkin(bumpyBall(), {0, 0, 1}, quality));
    camera = lookAlong({0, 0, -1}, {0, 1, 0}, skin.box(), 16.f / 9);
    look.lights = makeLightRig({}, homeFrame(camera), skin.box());
    picture = gl::Framebuffer({.size = {1280, 720}});
  }
  void draw() {
    view.draw({.surface = skin, .camera = camera, .look = look, .quality = quality}, picture);
    benchmark::DoNotOptimize(view.timing().final);  // waits for the picture
  }
};

void orbit(benchmark::State& state) {
  Scene scene;
  scene.look.skin.detail = state.range(0) ? 1 : 0;
  scene.draw();
  for (auto _ : state) {
    scene.camera.orbit(0.03f, 0);
    scene.draw();
  }
  state.SetLabel(state.range(0) ? "with pores" : "without pores");
}
BENCHMARK(orbit)
    ->Name("skin/orbit")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void relight(benchmark::State& state) {
  Scene scene;
  scene.draw();
  const bool all = state.range(0) == 1;
  LightOptions light;
  // The other lights stay until the movable one comes to the other side.
  const auto moveTo = [&](double azimuth) {
    light.azimuth = azimuth;
    scene.look.lights = makeLightRig(light, homeFrame(scene.camera), scene.skin.box());
    scene.view.relight(scene.skin, scene.look, scene.quality);
    benchmark::DoNotOptimize(scene.view.timing().combine);
  };
  moveTo(5);
  for (auto _ : state) moveTo(all ? -light.azimuth : light.azimuth > 80 ? 5 : light.azimuth + 10);
  const SkinView::Timing t = scene.view.timing();
  state.counters["maps_ms"] = t.lightMaps;
  state.counters["visibility_ms"] = t.visibility;
  state.counters["irradiance_ms"] = t.irradiance;
  state.counters["blurs_ms"] = t.blurs;
  state.counters["combine_ms"] = t.combine;
  state.counters["MB"] = double(scene.view.mapBytes()) / 1e6;
  const glm::ivec2 size = scene.skin.surface()->maps.size;
  state.SetLabel((all ? "all lights, " : "one light, ") + std::to_string(size.x) + "x" +
                 std::to_string(size.y) + " texels");
}
BENCHMARK(relight)
    ->Name("skin/relight")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace sonoskin
