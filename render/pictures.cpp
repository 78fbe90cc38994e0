#include "render/pictures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/volume/gaussian.h"
#include "core/volume/resample.h"
#include "render/gl/read_pixels.h"
#include "render/plane_slices.h"

namespace sonoskin {
namespace {

// voxelsInside: the part of a volume that holds all voxels inside a box of the world.
Volume<float> voxelsInside(const Volume<float>& volume, const Box& box) {
  const Geometry& g = volume.geometry;
  glm::dvec3 low(1e9), high(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::bvec3 far(corner & 1, corner & 2, corner & 4);
    const glm::dvec3 index = g.toIndex(glm::dvec3(glm::mix(box.min, box.max, far)));
    low = glm::min(low, index);
    high = glm::max(high, index);
  }
  const glm::dvec3 last(g.dims - 1);
  require(glm::all(glm::lessThan(low, last)) && glm::all(glm::greaterThan(high, glm::dvec3(0))),
          "the part of the volume to be shown is outside of it");
  const glm::ivec3 first(glm::floor(glm::max(low, 0.0)));
  const glm::ivec3 end = glm::ivec3(glm::ceil(glm::min(high, last))) + 1;
  return cropVolume(volume, first, end - first);
}

// How many rays along a pixel's side a smoothed volume needs: a picture finer than its voxels is interpolated.
float raysPerPixel(const Geometry& g, const Camera& camera, glm::ivec2 size) {
  constexpr float kRays = 1.15f, kFewest = 0.25f;  // along the smallest voxel's side; a pixel's
  const float tangent = std::tan(0.5f * glm::radians(camera.fieldOfView));
  const float pixel = 2 * camera.distance * tangent / float(size.y);  // mm
  return std::clamp(kRays * pixel / float(g.minSpacing()), kFewest, 1.0f);
}

float aspectOf(glm::ivec2 size) { return float(size.x) / float(size.y); }

}  // namespace

void checkPictureSize(glm::ivec2 size) {
  if (size.x < 16 || size.y < 16 || size.x > 8192 || size.y > 8192)
    throw Error(fmt::format("--size {}x{}: a picture has 16 to 8192 pixels a side", size.x, size.y),
                Error::Kind::usage);
}

Image takePictures(const PictureOptions& options, const Camera& first,
                   const std::function<void(const Camera& camera, const gl::Target& target)>& draw) {
  const gl::Framebuffer picture({.size = options.size});
  const auto take = [&](const Camera& camera) {
    draw(camera, picture);
    return gl::readImage(picture, !options.background);
  };
  if (!options.turntable) return take(first);
  const Turntable& table = *options.turntable;
  for (int view = 0; view < table.views; ++view)
    table.take(view, take(first.aroundBy(double(view) / table.views)));
  return {};
}

Lighting pictureLighting(const PictureOptions& options, const Camera& camera) {
  Lighting lighting = parseLighting(options.light, camera);
  lighting.background = options.background;
  return lighting;
}

namespace {

MeshViewInput meshInput(const GpuMesh& mesh, const Camera& camera, MeshLook look,
                        const PictureOptions& options) {
  return {.mesh = mesh,
          .camera = camera,
          .lighting = pictureLighting(options, camera),
          .look = look,
          .supersampling = 2,
          .unseenShade = options.unseenShade,
          .shadowSize = 2048};
}

}  // namespace

Image pictureOfMesh(gl::Context& context, std::shared_ptr<const Mesh> mesh, MeshLook look,
                    const PictureOptions& options) {
  checkPictureSize(options.size);
  context.makeCurrent();
  GpuMesh gpuMesh;
  gpuMesh.set(std::move(mesh));
  const Camera first =
      parseCamera(options.camera, options.beam, gpuMesh.box(), aspectOf(options.size), options.faceCamera());
  const ClipPlane clip = parseClip(options.clip, first, gpuMesh.box());
  MeshView view;
  return takePictures(options, first, [&](const Camera& camera, const gl::Target& target) {
    MeshViewInput input = meshInput(gpuMesh, camera, look, options);
    input.clip = clip;
    view.draw(input, target);
  });
}

namespace {

// VolumeStudio: a volume that pictures are taken of, and the surface within it where there is one.
struct VolumeStudio {
  const VolumePictureOptions& look;
  const PictureOptions& options;
  ClipPlane clip{};
  GpuVolume volume{};
  GpuMesh mesh{};
  Raycaster raycaster{};
  std::optional<MeshView> meshView{};
  gl::Framebuffer meshPicture{};

  void draw(const Camera& camera, const gl::Target& target);
  SurfaceBehind drawMesh(const Camera& camera);
};

SurfaceBehind VolumeStudio::drawMesh(const Camera& camera) {
  if (!meshView) {
    meshView.emplace();
    meshPicture = gl::Framebuffer({.size = options.size});
    mesh.set(look.mesh);
  }
  MeshViewInput input = meshInput(mesh, camera, MeshLook::clay, options);
  input.clip = clip;
  meshView->draw(input, meshPicture);
  return {meshView->buffer(), meshPicture};
}

void VolumeStudio::draw(const Camera& camera, const gl::Target& target) {
  const bool softens = look.look != VolumeLook::surface && look.smoothing >= 1;
  std::optional<SurfaceBehind> behind;
  if (look.mesh && look.look == VolumeLook::translucent) behind.emplace(drawMesh(camera));
  raycaster.draw({.volume = volume,
                  .camera = camera,
                  .lighting = pictureLighting(options, camera),
                  .look = look.look,
                  .iso = look.iso,
                  .transfer = look.transfer.value_or(amberTransfer(look.iso)),
                  .shadows = look.shadows,
                  .behind = behind ? &*behind : nullptr,
                  .gradientReach = 1.5f,
                  .part = {.clip = clip},
                  .raysPerPixel = softens ? raysPerPixel(volume.geometry(), camera, options.size) : 1},
                 target);
}

}  // namespace

Image pictureOfVolume(gl::Context& context, std::shared_ptr<const Volume<float>> volume,
                      const VolumePictureOptions& look, const PictureOptions& options) {
  checkPictureSize(options.size);
  if (!(look.iso > 0 && look.iso < 1))
    throw Error(fmt::format("an iso-value of {} is not between 0 and 1", look.iso), Error::Kind::usage);
  context.makeCurrent();
  // Cut the volume itself, so that what is left out casts no shadow and costs nothing.
  if (look.crop) volume = std::make_shared<const Volume<float>>(voxelsInside(*volume, *look.crop));
  if (look.smoothing > 0)
    volume = std::make_shared<const Volume<float>>(gaussianBlur(*volume, look.smoothing));
  VolumeStudio studio{look, options};
  studio.volume.set(volume);
  const Box framed = look.crop ? worldBox(volume->geometry) : studio.volume.contentBox(look.iso);
  const Camera first =
      parseCamera(options.camera, options.beam, framed, aspectOf(options.size), options.faceCamera());
  studio.clip = parseClip(options.clip, first, framed);
  return takePictures(options, first,
                      [&](const Camera& camera, const gl::Target& target) { studio.draw(camera, target); });
}

glm::dvec3 brightMiddle(const Volume<float>& volume) {
  const Geometry& g = volume.geometry;
  std::vector<glm::dvec4> sums(std::size_t(g.dims.z),
                               glm::dvec4(0));  // weight * index, and weight, per slice
  parallelFor(g.dims.z, [&](std::ptrdiff_t k) {
    glm::dvec4 sum(0);
    for (int j = 0; j < g.dims.y; ++j)
      for (int i = 0; i < g.dims.x; ++i) {
        const double weight = double(volume.at(i, j, int(k))) * volume.at(i, j, int(k));
        sum += weight * glm::dvec4(i, j, k, 1);
      }
    sums[std::size_t(k)] = sum;
  });
  glm::dvec4 total(0);
  for (const auto& sum : sums) total += sum;
  return g.toWorld(total.w > 0 ? glm::dvec3(total) / total.w : 0.5 * glm::dvec3(g.dims - 1));
}

namespace {

// The sides of the region's box, around its outermost voxels; none where nothing is cut.
std::optional<std::array<glm::dvec3, 2>> boxOf(Region region, const Geometry& g) {
  region.erased.reset();
  region.last = glm::min(region.last, g.dims - 1);
  if (isWhole(region, g)) return {};
  return std::array{g.toWorld(glm::dvec3(region.first) - 0.5), g.toWorld(glm::dvec3(region.last) + 0.5)};
}

int columnsOf(const SlicesInput& input) { return 1 + (input.classified ? 1 : 0) + (input.thinned ? 1 : 0); }

// SlicesFrame: what the panels of a picture of slices share, and where they lie: in three rows, the first on top.
struct SlicesFrame {
  static constexpr int kGap = 3;  // pixels between the panels
  const SlicesInput& input;
  const gl::Framebuffer& picture;
  glm::dvec3 cursor;
  glm::ivec2 panel;
  GpuMask erased{};

  // OpenGL counts from the bottom.
  gl::Target target(int row, int column) const {
    return {picture.name(),
            {(panel.x + kGap) * column, picture.size().y - panel.y - (panel.y + kGap) * row},
            panel};
  }
};

// One plane: raw, classified, and thinned in colour over raw, of the slices alone that it lies between.
void drawRow(SliceView& view, const SlicesFrame& frame, int row) {
  const SlicesInput& input = frame.input;
  const SliceCamera camera{
      .plane = input.rows[std::size_t(row)], .cursor = frame.cursor, .planes = input.planes};
  const int across = camera.axes().across;
  GpuVolume raw, classified, thinned;
  raw.set(slicesAround(input.raw, across, camera.cursor));
  classified.set(slicesAround(input.classified, across, camera.cursor));
  thinned.set(slicesAround(input.thinned, across, camera.cursor));
  int column = input.lastAlone ? 1 - columnsOf(input) : 0;
  const auto draw = [&](const GpuVolume& volume, const GreyWindow& window, const GpuVolume* overlay) {
    if (column++ < 0) return;
    view.draw({.frame = input.raw->geometry,
               .camera = camera,
               .volume = volume,
               .window = window,
               .overlay = overlay,
               .erased = &frame.erased,
               .box = boxOf(input.region, input.raw->geometry),
               .crossHair = !input.lastAlone},
              frame.target(row, column - 1));
  };
  draw(raw, {}, nullptr);
  if (input.classified) draw(classified, {}, nullptr);
  // Raw at half its brightness, so that the colour stands out.
  if (input.thinned) draw(raw, {1.0f, 2.0f}, &thinned);
}

}  // namespace

Image pictureOfSlices(gl::Context& context, const SlicesInput& input, glm::ivec2 size) {
  checkPictureSize(size);
  context.makeCurrent();
  const gl::Framebuffer picture({.size = size});
  picture.clear({0.10f, 0.11f, 0.12f, 1});
  const glm::ivec2 panels(input.lastAlone ? 1 : columnsOf(input), int(input.rows.size()));
  SlicesFrame frame{
      input, picture,
      input.cursor ? *input.cursor : brightMiddle(input.classified ? *input.classified : *input.raw),
      glm::max((size - SlicesFrame::kGap * (panels - 1)) / panels, glm::ivec2(1))};
  if (input.region.erased) frame.erased.set(*input.region.erased, Hasher("erased").key());
  SliceView view;
  for (int row = 0; row < panels.y; ++row) drawRow(view, frame, row);
  return gl::readImage(picture);
}

}  // namespace sonoskin
