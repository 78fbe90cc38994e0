#pragma once

#include <memory>

#include "core/io/textured_mesh_writer.h"
#include "core/pipeline/parameters.h"
#include "render/gl/context.h"
#include "render/pictures.h"
#include "render/skin/skin_view.h"

namespace sonoskin {

// BakeOptions: what a surface's pictures hold.
//   light    the light that has gone through the skin as well, which is then not lit again; without it colour, normals
//            (pores and fine lines) and roughness
struct BakeOptions {
  SkinQuality quality = pictureQuality();
  bool light = false;
};

// bakeSkin: a surface with the skin's maps as pictures, to be written by writeTexturedMesh.
//   options   its beam says where the front is, from where the lights' angles count
//   cost      0.5 M triangles in full quality: about 6 s on two cores without a graphics card
//   errors    Error: no triangles; Cancelled
TexturedMesh bakeSkin(gl::Context& context, std::shared_ptr<const Mesh> mesh, const Parameters& parameters,
                      const BakeOptions& bake, const PictureOptions& options, const Progress& progress = {});

// bakeSurface: the same of a surface that is prepared.
TexturedMesh bakeSurface(const GpuSkin& surface, const SkinLook& look, const BakeOptions& bake);

}  // namespace sonoskin
