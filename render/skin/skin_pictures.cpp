#include "render/skin/skin_pictures.h"

#include <cmath>

#include "core/base/free_memory.h"
#include "core/skin/skin_material.h"
#include "render/gl/read_pixels.h"

namespace sonoskin {
namespace {

constexpr int kSupersampling = 2;

// The home view of a camera's words: its preset without the changes.
std::string_view presetOf(std::string_view camera) {
  const std::string_view first = camera.substr(0, camera.find(','));
  return first.find('=') == std::string_view::npos && !first.empty() ? first : "probe";
}

// The lights of the parameters, or where the picture has words of its own, those from the camera's place.
LightOptions lightsOf(const Parameters& parameters, const PictureOptions& options, const Camera& camera,
                      const HomeFrame& home) {
  LightOptions light = parameters.light;
  if (options.light == "portrait") return light;
  const Lighting studio = portraitLighting(camera), asked = parseLighting(options.light, camera);
  const glm::vec2 angles = lightAngles(asked.key.direction, home);
  light.azimuth = double(angles.x);
  light.elevation = double(angles.y);
  light.strength *= double(asked.key.colour.g / studio.key.colour.g);
  return light;
}

// What of the surface light can come from to what the camera sees. An integral over the surface has no end.
SkinSight sightOf(const Camera& camera, const glm::ivec2& size, const Box& box, const SkinOptions& skin) {
  constexpr double kWidths = 3;  // of the widest Gaussian
  const glm::ivec2 samples = size * kSupersampling;
  const double variance = makeSkinMaterial(skin).diffusion.variances.back();
  const float nearest =
      std::max(0.f, glm::dot(box.centre() - camera.eye(), camera.forward) - 0.5f * box.diagonal());
  return {.viewProjection = camera.projection(float(size.x) / float(size.y), box) * camera.view(),
          .size = samples,
          .reach = float(kWidths * std::sqrt(variance)),
          .sample = camera.millimetresPerPixel(samples.y) * nearest / camera.distance};
}

}  // namespace

Image pictureOfSkin(gl::Context& context, std::shared_ptr<const Mesh> mesh, const Parameters& parameters,
                    const SkinPictureOptions& look, const PictureOptions& options, const Progress& progress) {
  checkPictureSize(options.size);
  const Box box = boundingBox(mesh->positions);
  const float aspect = float(options.size.x) / float(options.size.y);
  const Camera camera = parseCamera(options.camera, options.beam, box, aspect, options.faceCamera());
  const HomeFrame home =
      homeFrame(parseCamera(presetOf(options.camera), options.beam, box, aspect, options.faceCamera()));
  const SkinLook skin{parameters.skin, parameters.landmarks,
                      makeLightRig(lightsOf(parameters, options, camera, home), home, box)};
  const bool integrates = look.quality.diffusion == DiffusionMethod::reference;  // the longest part then
  const bool allAround = integrates || options.turntable;
  const SkinSight sight = allAround ? SkinSight{} : sightOf(camera, options.size, box, parameters.skin);
  const auto surface =
      prepareSkin(std::move(mesh), home.back, look.quality, sight, progress.part(0, integrates ? 0.1 : 0.8));

  context.makeCurrent();
  GpuSkin gpu;
  gpu.set(surface);
  if (!integrates) surface->keepForLight();
  returnFreeMemory();
  SkinView view;
  const Progress lit = progress.part(integrates ? 0.1 : 0.8, 0.95);
  if (showsMap(look.pass))
    view.relight(gpu, skin, look.quality, lit);
  else
    view.relightOnce(gpu, skin, look.quality, lit);
  const ClipPlane clip = parseClip(options.clip, camera, box);
  Image picture = takePictures(options, camera, [&](const Camera& place, const gl::Target& target) {
    progress.throwIfCancelled();
    view.draw({.surface = gpu,
               .camera = place,
               .look = skin,
               .quality = look.quality,
               .supersampling = kSupersampling,
               .pass = look.pass,
               .unseenShade = options.unseenShade,
               .background = options.background,
               .clip = clip},
              target);
  });
  progress.update(1);
  return picture;
}

}  // namespace sonoskin
