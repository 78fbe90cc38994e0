#pragma once

#include <CLI/App.hpp>
#include <string>

#include "render/pictures.h"

namespace sonoskin {

// VolumeRenderOptions: --mode, --level, --whole, --transfer, --no-shadows and --with-mesh of `render --view volume`.
struct VolumeRenderOptions {
  std::string mode = "dvr", transfer = "amber";
  double level = 0;
  bool whole = false, shadows = true, withMesh = false;

  // picture: the look of a picture.
  //   level   grey of the skin's border
  //   errors  Error: the transfer function is neither a name nor a file of one
  VolumePictureOptions picture(float border) const;
};
void addVolumeOptions(CLI::App& command, VolumeRenderOptions& options);

// checkVolumeOptions: refuses, before any work, what does not go together, or a transfer function that is none.
//   errors  Error
void checkVolumeOptions(const VolumeRenderOptions& options);

}  // namespace sonoskin
