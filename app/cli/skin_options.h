#pragma once

#include <CLI/App.hpp>
#include <string>

#include "app/batch/batch.h"
#include "render/skin/skin_pictures.h"

namespace sonoskin {

// SkinRenderOptions: --pass, --reference and --quality of pictures of skin; --own-coordinates and --bake of `render`.
struct SkinRenderOptions {
  SkinPictureOptions look;
  bool reference = false;
  Bake bake = Bake::none;

  // picture: the look of a picture; maps for files have no reference.
  SkinPictureOptions picture() const;
};
// addSkinLook: the first three of them. addSkinOptions: all.
void addSkinLook(CLI::App& command, SkinRenderOptions& options);
void addSkinOptions(CLI::App& command, SkinRenderOptions& options);

// checkSkinOptions: refuses, before any work, what does not go together, and an output that cannot be written.
//   errors  Error (usage)
void checkSkinOptions(const SkinRenderOptions& options, const std::string& view, const std::string& out);

// addQualityOption: --quality full|light. addBakeOption: --bake colour|light.
void addQualityOption(CLI::App& command, SkinQuality& quality);
void addBakeOption(CLI::App& command, Bake& bake);

}  // namespace sonoskin
