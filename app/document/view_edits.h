#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/measures.h"
#include "render/clip_plane.h"
#include "render/transfer_presets.h"

namespace sonoskin {

// ClipShow: the plane that cuts what the 3D view shows.
struct ClipShow {
  bool on = false;
  ClipPlane plane;
  friend bool operator==(const ClipShow&, const ClipShow&) = default;
};

// VolumeColours: those of a translucent volume.
//   name     the transfer function's: a preset's, or that of one of the person's own
//   own      the function as the person made or loaded it; without one the preset's
//   changed  since it had its name
struct VolumeColours {
  std::string name = "amber";
  std::optional<LevelledTransfer> own;
  bool changed = false;
  friend bool operator==(const VolumeColours&, const VolumeColours&) = default;
};

// ViewEdits: what a person makes in the views and undo takes back.
struct ViewEdits {
  std::vector<Measure> measures;
  ClipShow clip;
  VolumeColours colours;
  friend bool operator==(const ViewEdits&, const ViewEdits&) = default;
};

}  // namespace sonoskin
