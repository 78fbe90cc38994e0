#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/io/image.h"
#include "core/mesh/mesh.h"
#include "core/surface/region.h"
#include "render/camera.h"
#include "render/gl/context.h"
#include "render/mesh_view.h"
#include "render/raycaster.h"
#include "render/slice_view.h"

namespace sonoskin {

// Turntable: pictures all around, at equal angles, the camera turning to its right about what it looks at.
//   views  1 or more
//   take   gets each as it is drawn, from 0 on
struct Turntable {
  int views = 1;
  std::function<void(int view, Image)> take;
};

// PictureOptions: the frame of a finished picture.
//   background  without one, what is not covered is transparent
//   clip        see parseClip
//   turntable   where it is set, the pictures go there and what is returned has no pixels
struct PictureOptions {
  glm::ivec2 size{1280, 960};      // pixels
  std::string camera = "probe";    // see parseCamera
  std::string light = "portrait";  // see parseLighting
  Beam beam{};                     // what "probe" means
  bool background = true;
  std::string clip = "";
  std::optional<Turntable> turntable{};
  float unseenShade = 0;         // of surfaces; 0 to 1: how far what was not measured is greyed
  std::optional<Camera> face{};  // what "face" means

  const Camera* faceCamera() const { return face ? &*face : nullptr; }
};

// checkPictureSize: refuses pictures of fewer than 16 or more than 8192 pixels a side.
void checkPictureSize(glm::ivec2 size);

// takePictures: what a scene looks like from a camera, or from all around where a turntable is asked for.
//   draw  one picture of options.size; its lights may go with the camera
Image takePictures(const PictureOptions& options, const Camera& first,
                   const std::function<void(const Camera& camera, const gl::Target& target)>& draw);

// pictureLighting: the light that the options ask for, with a background or without.
Lighting pictureLighting(const PictureOptions& options, const Camera& camera);

// pictureOfMesh: the lit surface, four samples per pixel.
//   mesh    world mm; may be empty (background only)
//   errors  Error (usage): the camera's text is wrong, or the size is not within 16 to 8192 pixels
//   cost    about 1 s for 600,000 triangles at 1280x960 with two cores and no graphics card
Image pictureOfMesh(gl::Context& context, std::shared_ptr<const Mesh> mesh, MeshLook look,
                    const PictureOptions& options);

// VolumePictureOptions: how a volume is shown.
//   iso        0 to 1, the grey value at the skin's border; the pipeline's Results::visibleLevel where it ran
//   smoothing  standard deviation of a low-pass before, in units of the smallest spacing; 0: none
//   crop       world mm; only what is inside is shown, and fills the picture; without one, everything
//   transfer   without one, the amber one of the iso-value (translucent)
//   shadows    see RaycastInput
//   mesh       may be null; shown within the volume (translucent)
struct VolumePictureOptions {
  VolumeLook look = VolumeLook::translucent;
  float iso = 0.3f;
  double smoothing = 1.2;
  std::optional<Box> crop{};
  std::optional<TransferFunction> transfer{};
  bool shadows = true;
  std::shared_ptr<const Mesh> mesh{};
};

// pictureOfVolume: the volume itself, without a mesh; the camera frames what is brighter than the iso-value.
//   volume  values 0 to 1, bright is tissue
//   errors  as pictureOfMesh; Error (usage): iso not within 0 to 1; Cancelled
//   cost    about 0.3 s for 467x255x124 at 1280x960 with two cores and no graphics card: a translucent volume that was
//           smoothed gets one or two rays per voxel's side, not one per pixel
Image pictureOfVolume(gl::Context& context, std::shared_ptr<const Volume<float>> volume,
                      const VolumePictureOptions& look, const PictureOptions& options);

// SlicesInput: what a picture of slices shows; a null pointer leaves its column out.
//   raw         the recorded volume; must be there
//   cursor      world mm, where the three planes meet; without one, the middle of what is bright
//   region      its box and what is erased are marked where they are not the whole volume
//   planes      how the three planes lie in the volume
//   rows        which of them
//   lastAlone   only the last of the columns, without the lines of the other planes
struct SlicesInput {
  std::shared_ptr<const Volume<float>> raw, classified;
  std::shared_ptr<const Volume<std::uint8_t>> thinned;
  std::optional<glm::dvec3> cursor;
  Region region{};
  PlaneAxes planes{};
  std::vector<Plane> rows{kPlanes.begin(), kPlanes.end()};
  bool lastAlone = false;
};

// pictureOfSlices: three rows (axial, sagittal, coronal) and a column each for the raw volume, the classified
// one, and the thinned one in colour over the raw one.
//   cost    only the slices next to the three planes are looked at; about 60 ms at 1280x960
//   errors  Error (usage): the size, as pictureOfMesh
Image pictureOfSlices(gl::Context& context, const SlicesInput& input, glm::ivec2 size);

// brightMiddle: the mean position of the voxels, weighted by the square of their values; world mm.
glm::dvec3 brightMiddle(const Volume<float>& volume);

}  // namespace sonoskin
