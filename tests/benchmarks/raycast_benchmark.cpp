// The ray-caster at 800x600 around the simulated scan at full size, one picture after each turn of the camera. Where
// SONOSKIN_RACE names a folder, the translucent look without shadows is written there for tests/benchmarks/raycast_vtk.py: the
// camera, the transfer function, the lights and the picture.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "render/gl/context.h"
#include "render/gl/gpu_timer.h"
#include "render/gl/read_pixels.h"
#include "render/raycaster.h"
#include "tests/benchmarks/phantom_input.h"

namespace sonoskin {
namespace {

constexpr float kBorder = 0.3f;  // grey of the phantom's skin

struct VolumeScene {
  std::unique_ptr<gl::Context> context = gl::makeOffscreenContext(gl::Backend::egl);
  GpuVolume volume;
  Raycaster raycaster;
  gl::GpuTimer timer;
  Camera camera;
  gl::Framebuffer picture;

  VolumeScene() {
    context->makeCurrent();
    volume.set(phantomInput().volume);
    const Beam beam = beamOf(phantomInput(), {});
    camera = lookAlong(glm::vec3(beam.axis), glm::vec3(beam.up), worldBox(volume.geometry()), 4.0f / 3);
    picture = gl::Framebuffer({.size = {800, 600}});
  }
  RaycastInput input(VolumeLook look, bool shadows) {
    return {.volume = volume,
            .camera = camera,
            .lighting = portraitLighting(camera),
            .look = look,
            .iso = kBorder,
            .transfer = amberTransfer(kBorder),
            .shadows = shadows};
  }
  void draw(VolumeLook look, bool shadows) {
    timer.begin();
    raycaster.draw(input(look, shadows), picture);
    timer.end();
    benchmark::DoNotOptimize(timer.seconds());  // waits for the picture
  }
};

nlohmann::json numbers(const glm::vec3& v) { return {v.x, v.y, v.z}; }

// What another program needs for the same picture.
void writeRace(VolumeScene& scene, const std::filesystem::path& folder) {
  const RaycastInput input = scene.input(VolumeLook::translucent, false);
  const Lighting& l = input.lighting;
  nlohmann::json transfer = nlohmann::json::array();
  const double layers = scene.volume.geometry().minSpacing() * 250 / worldDiagonal(scene.volume.geometry());
  for (int i = 0; i < 256; ++i) {
    const glm::vec4 look = input.transfer.at(float(i) / 255);
    transfer.push_back({look.r, look.g, look.b, 1 - std::pow(1 - double(look.a), layers)});
  }
  const Geometry& g = scene.volume.geometry();
  nlohmann::json race{{"size", {scene.picture.size().x, scene.picture.size().y}},
                      {"eye", numbers(scene.camera.eye())},
                      {"target", numbers(scene.camera.target)},
                      {"up", numbers(scene.camera.up)},
                      {"angle", scene.camera.fieldOfView},
                      {"step", scene.volume.geometry().minSpacing()},
                      {"transfer", transfer},
                      {"key", {numbers(l.key.direction), numbers(l.key.colour)}},
                      {"fill", {numbers(l.fill.direction), numbers(l.fill.colour)}},
                      {"ambient", numbers(0.5f * (l.sky + l.ground))}};
  race["dims"] = {g.dims.x, g.dims.y, g.dims.z};
  race["spacing"] = numbers(glm::vec3(g.spacing));
  race["origin"] = numbers(glm::vec3(g.origin));
  for (int axis = 0; axis < 3; ++axis) race["direction"].push_back(numbers(glm::vec3(g.direction[axis])));
  std::ofstream(folder / "race.json") << race.dump();
  scene.draw(VolumeLook::translucent, false);
  const auto texels = gl::readFloats(scene.raycaster.translucent().colour(), 4);
  std::ofstream(folder / "ours.f32", std::ios::binary)
      .write(reinterpret_cast<const char*>(texels.data()), std::streamsize(texels.size() * sizeof(float)));
  const Volume<float>& volume = *phantomInput().volume;
  std::vector<std::uint8_t> bytes;
  for (const float value : volume.data)
    bytes.push_back(std::uint8_t(255 * std::clamp(value, 0.0f, 1.0f) + 0.5f));
  std::ofstream(folder / "scan.u8", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

void orbit(benchmark::State& state, VolumeLook look, bool shadows) {
  VolumeScene scene;
  scene.draw(look, shadows);
  const char* folder = std::getenv("SONOSKIN_RACE");
  if (folder && look == VolumeLook::translucent && !shadows) writeRace(scene, folder);
  for (auto _ : state) {
    scene.camera.orbit(0.03f, 0);
    scene.draw(look, shadows);
  }
}
BENCHMARK_CAPTURE(orbit, surface, VolumeLook::surface, false)
    ->Name("raycast/surface")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(orbit, translucent, VolumeLook::translucent, true)
    ->Name("raycast/translucent")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(orbit, shadowless, VolumeLook::translucent, false)
    ->Name("raycast/shadowless")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(orbit, maximum, VolumeLook::maximum, false)
    ->Name("raycast/maximum")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace sonoskin
