#pragma once

#include <memory>

#include "core/io/image.h"
#include "core/pipeline/parameters.h"
#include "render/gl/context.h"
#include "render/pictures.h"
#include "render/skin/skin_view.h"

namespace sonoskin {

// SkinPictureOptions: how skin is shown in a finished picture.
struct SkinPictureOptions {
  SkinQuality quality = pictureQuality();
  SkinPass pass = SkinPass::skin;
};

// pictureOfSkin: the surface as skin with the lights of `parameters`, four samples per pixel.
//   options  as for pictureOfMesh; its light's azimuth, elevation and strength count from the camera and go before those
//            of the parameters
//   errors   as pictureOfMesh; Cancelled
Image pictureOfSkin(gl::Context& context, std::shared_ptr<const Mesh> mesh, const Parameters& parameters,
                    const SkinPictureOptions& look, const PictureOptions& options,
                    const Progress& progress = {});

}  // namespace sonoskin
