#pragma once

#include <memory>
#include <string>

#include "core/io/image.h"
#include "core/mesh/mesh.h"
#include "render/camera.h"
#include "render/gl/context.h"
#include "render/mesh_view.h"

namespace sonoskin {

// PictureOptions: the frame of a finished picture.
struct PictureOptions {
  glm::ivec2 size{1280, 960};    // pixels
  std::string camera = "probe";  // see parseCamera
  Beam beam;                     // what "probe" means
};

// pictureOfMesh: the lit surface, four samples per pixel.
//   mesh    world mm; may be empty (background only)
//   errors  Error (usage): the camera's text is wrong, or the size is not within 16 to 8192 pixels
//   cost    about 1 s for 600,000 triangles at 1280x960 with two cores and no graphics card
Image pictureOfMesh(gl::Context& context, std::shared_ptr<const Mesh> mesh, MeshLook look,
                    const PictureOptions& options);

}  // namespace sonoskin
