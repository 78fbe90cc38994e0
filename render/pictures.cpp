#include "render/pictures.h"

#include "core/base/error.h"
#include "render/gl/read_pixels.h"

namespace sonoskin {
namespace {

void checkSize(glm::ivec2 size) {
  if (size.x < 16 || size.y < 16 || size.x > 8192 || size.y > 8192)
    throw Error(fmt::format("--size {}x{}: a picture has 16 to 8192 pixels a side", size.x, size.y),
                Error::Kind::usage);
}

float aspectOf(glm::ivec2 size) { return float(size.x) / float(size.y); }

}  // namespace

Image pictureOfMesh(gl::Context& context, std::shared_ptr<const Mesh> mesh, MeshLook look,
                    const PictureOptions& options) {
  checkSize(options.size);
  context.makeCurrent();
  GpuMesh gpuMesh;
  gpuMesh.set(std::move(mesh));
  const Camera camera = parseCamera(options.camera, options.beam, gpuMesh.box(), aspectOf(options.size));
  const gl::Framebuffer picture({.size = options.size});
  MeshView view;
  view.draw({.mesh = gpuMesh,
             .camera = camera,
             .lighting = portraitLighting(camera),
             .look = look,
             .supersampling = 2,
             .shadowSize = 2048},
            picture);
  return gl::readImage(picture);
}

}  // namespace sonoskin
