#include "render/pictures.h"

#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/volume/gaussian.h"
#include "core/volume/resample.h"
#include "render/gl/read_pixels.h"

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

float aspectOf(glm::ivec2 size) { return float(size.x) / float(size.y); }

}  // namespace

void checkPictureSize(glm::ivec2 size) {
  if (size.x < 16 || size.y < 16 || size.x > 8192 || size.y > 8192)
    throw Error(fmt::format("--size {}x{}: a picture has 16 to 8192 pixels a side", size.x, size.y),
                Error::Kind::usage);
}

Image pictureOfMesh(gl::Context& context, std::shared_ptr<const Mesh> mesh, MeshLook look,
                    const PictureOptions& options) {
  checkPictureSize(options.size);
  context.makeCurrent();
  GpuMesh gpuMesh;
  gpuMesh.set(std::move(mesh));
  const Camera camera =
      parseCamera(options.camera, options.beam, gpuMesh.box(), aspectOf(options.size), options.faceCamera());
  const gl::Framebuffer picture({.size = options.size});
  MeshView view;
  view.draw({.mesh = gpuMesh,
             .camera = camera,
             .lighting = parseLighting(options.light, camera),
             .look = look,
             .supersampling = 2,
             .unseenShade = options.unseenShade,
             .shadowSize = 2048},
            picture);
  return gl::readImage(picture);
}

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
  GpuVolume gpuVolume;
  gpuVolume.set(volume);
  const Box framed = look.crop ? worldBox(volume->geometry) : gpuVolume.contentBox(look.iso);
  const Camera camera =
      parseCamera(options.camera, options.beam, framed, aspectOf(options.size), options.faceCamera());
  const gl::Framebuffer picture({.size = options.size});
  Raycaster raycaster;
  raycaster.draw({.volume = gpuVolume,
                  .camera = camera,
                  .lighting = parseLighting(options.light, camera),
                  .look = look.look,
                  .iso = look.iso,
                  .transfer = amberTransfer(look.iso),
                  .gradientReach = 1.5f},
                 picture);
  return gl::readImage(picture);
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

// One column of a picture of slices.
struct Column {
  GpuVolume volume;
  const GpuVolume* overlay = nullptr;
  GreyWindow window{};
};

std::vector<Column> columnsOf(const SlicesInput& input, GpuVolume& thinned) {
  std::vector<Column> columns(1);
  columns[0].volume.set(input.raw);
  if (input.classified) columns.emplace_back().volume.set(input.classified);
  if (input.thinned) {
    thinned.set(input.thinned);
    Column& column = columns.emplace_back();
    column.volume.set(input.raw);
    column.overlay = &thinned;
    column.window = {1.0f, 2.0f};  // raw at half its brightness, so that the colour stands out
  }
  return columns;
}

// The sides of the region's box, around its outermost voxels; none where nothing is cut.
std::optional<std::array<glm::dvec3, 2>> boxOf(Region region, const Geometry& g) {
  region.erased.reset();
  region.last = glm::min(region.last, g.dims - 1);
  if (isWhole(region, g)) return {};
  return std::array{g.toWorld(glm::dvec3(region.first) - 0.5), g.toWorld(glm::dvec3(region.last) + 0.5)};
}

}  // namespace

Image pictureOfSlices(gl::Context& context, const SlicesInput& input, glm::ivec2 size) {
  checkPictureSize(size);
  context.makeCurrent();
  GpuVolume thinned;
  const auto columns = columnsOf(input, thinned);
  const glm::dvec3 cursor =
      input.cursor.value_or(brightMiddle(input.classified ? *input.classified : *input.raw));
  const gl::Framebuffer picture({.size = size});
  picture.clear({0.10f, 0.11f, 0.12f, 1});
  constexpr int kGap = 3;  // pixels between the panels
  const int count = int(columns.size());
  const glm::ivec2 panel =
      glm::max((size - kGap * (glm::ivec2(count, 3) - 1)) / glm::ivec2(count, 3), glm::ivec2(1));
  GpuMask erased;
  if (input.region.erased) erased.set(*input.region.erased, Hasher("erased").key());
  SliceView view;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < count; ++column) {
      const Column& c = columns[std::size_t(column)];
      const SliceCamera camera{.plane = kPlanes[std::size_t(row)], .cursor = cursor};
      // The first row is on top; OpenGL counts from the bottom.
      const glm::ivec2 corner((panel.x + kGap) * column, size.y - panel.y - (panel.y + kGap) * row);
      view.draw({.frame = input.raw->geometry,
                 .camera = camera,
                 .volume = c.volume,
                 .window = c.window,
                 .overlay = c.overlay,
                 .erased = &erased,
                 .box = boxOf(input.region, input.raw->geometry)},
                gl::Target(picture.name(), corner, panel));
    }
  return gl::readImage(picture);
}

}  // namespace sonoskin
